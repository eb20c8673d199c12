import { tell } from '../state/messages'
import type { Setup } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { type Shelf, savePreferences, saveSetup } from './storage'

const QUIET_MS = 400

const REFUSED =
  'This browser keeps nothing for the next visit: its storage is full or not allowed. Save the map to keep it.'

/**
 * Keeps what is drawn for the next visit: a moment after the last change, and when the page is left.
 * If nothing can be kept, that is said once.
 * @param isLinked whether a setup is that of a link, which takes the place of what was drawn only once
 *   it is changed
 */
export function keep(
  store: Store<State>,
  shelf: Shelf | null,
  isLinked: (setup: Setup) => boolean,
): void {
  let timer: ReturnType<typeof setTimeout> | undefined
  let drawn = store.state.committed
  let kept = drawn
  let hasRefused = false

  const keepNow = () => {
    clearTimeout(timer)
    if (drawn === kept) return
    kept = drawn
    if (saveSetup(shelf, drawn) || hasRefused) return
    hasRefused = true
    store.update((state) => tell(state, 'note', REFUSED))
  }
  window.addEventListener('pagehide', keepNow)

  store.subscribe((now, before) => {
    if (now.preferences !== before.preferences) savePreferences(shelf, now.preferences)
    if (now.committed === before.committed || isLinked(now.committed)) return
    drawn = now.committed
    clearTimeout(timer)
    timer = setTimeout(keepNow, QUIET_MS)
  })
}
