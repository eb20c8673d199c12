import { zoomAt } from '../../render/view'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { look } from '../state/transitions'
import type { Hand } from './hand'

/** How Safari tells of a pinch, on a touchpad in place of a wheel with Ctrl. */
interface GestureEvent extends UIEvent {
  readonly clientX: number
  readonly clientY: number
  /** How far apart the fingers are, where 1 is where they began. */
  readonly scale: number
}

declare global {
  interface HTMLElementEventMap {
    gesturestart: GestureEvent
    gesturechange: GestureEvent
  }
}

/** Binds Safari's pinch on a touchpad to the map; else Safari would zoom the page. */
export function bindGesture(host: HTMLElement, store: Store<State>, hand: Hand): void {
  let latest = 1
  host.addEventListener('gesturestart', (event) => {
    event.preventDefault()
    latest = event.scale
  })
  host.addEventListener('gesturechange', (event) => {
    event.preventDefault()
    const factor = event.scale / latest
    latest = event.scale
    // Fingers on the screen are told of in this way, too, and the hand follows them already.
    if (hand.isBusy) return
    const { clientX: x, clientY: y } = event
    store.update((state) => look(state, zoomAt(state.view, factor, x, y, state.setup.problem.grid)))
  })
}
