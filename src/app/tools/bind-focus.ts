import type { State } from '../state/state'
import type { Store } from '../state/store'
import { hideCursor, moveCursor } from '../state/transitions'

/**
 * Shows the cursor while the map has the focus, unless that came by a pointer: then the cell is under
 * it, and only the keyboard needs a cursor.
 * @returns what a pointer gives the map the focus with
 */
export function bindFocus(host: HTMLElement, store: Store<State>): () => void {
  let isPressed = false
  let isWindowAway = false

  host.addEventListener('focus', () => {
    // A window that comes back gives the focus back to where it was, however that came.
    const byPointer = isPressed || isWindowAway
    isWindowAway = false
    if (host.matches(':focus-visible') || !byPointer) {
      store.update((state) => moveCursor(state, state.cursor))
    }
  })
  host.addEventListener('blur', () => store.update((state) => hideCursor(state)))
  window.addEventListener('blur', () => {
    isWindowAway = document.activeElement === host
  })
  return () => {
    isPressed = true
    // Where nothing had the focus before, browsers would take this for the keyboard's.
    host.focus({ preventScroll: true, focusVisible: false })
    isPressed = false
  }
}
