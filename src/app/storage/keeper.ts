import { tell } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { type Shelf, savePreferences, saveSetup } from './storage'

const QUIET_MS = 400

const REFUSED =
  'This browser keeps nothing for the next visit: its storage is full or not allowed. Save the map to keep it.'

/**
 * Keeps what is drawn for the next visit: a moment after the last change, and when the page is left.
 * If nothing can be kept, that is said once.
 */
export function keep(store: Store<State>, shelf: Shelf | null): void {
  let timer: ReturnType<typeof setTimeout> | undefined
  let kept = store.state.committed
  let hasRefused = false

  const keepNow = () => {
    clearTimeout(timer)
    const { committed } = store.state
    if (committed === kept) return
    kept = committed
    if (saveSetup(shelf, committed) || hasRefused) return
    hasRefused = true
    store.update((state) => tell(state, 'note', REFUSED))
  }
  window.addEventListener('pagehide', keepNow)

  store.subscribe((now, before) => {
    if (now.preferences !== before.preferences) savePreferences(shelf, now.preferences)
    if (now.committed === before.committed) return
    clearTimeout(timer)
    timer = setTimeout(keepNow, QUIET_MS)
  })
}
