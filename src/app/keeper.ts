import type { State } from './state'
import { type Shelf, savePreferences, saveSetup } from './storage'

const QUIET_MS = 400

/**
 * Keeps what is drawn for the next visit: a moment after the last change, and when the page goes.
 * Calls `refused` the first time that nothing can be kept.
 */
export function keeper(
  shelf: Shelf | null,
  state: () => State,
  refused: () => void,
): (now: State, before: State) => void {
  let timer: ReturnType<typeof setTimeout> | undefined
  let kept = state().committed
  let hasRefused = false

  const keep = () => {
    clearTimeout(timer)
    timer = undefined
    const { committed } = state()
    if (committed === kept) return
    kept = committed
    if (saveSetup(shelf, committed) || hasRefused) return
    hasRefused = true
    refused()
  }
  window.addEventListener('pagehide', keep)

  return (now, before) => {
    if (now.preferences !== before.preferences) savePreferences(shelf, now.preferences)
    if (now.committed === before.committed) return
    clearTimeout(timer)
    timer = setTimeout(keep, QUIET_MS)
  }
}
