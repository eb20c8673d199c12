import type { State } from '../state/state'
import type { Store } from '../state/store'
import { bindFocus } from './bind-focus'
import { bindGesture } from './bind-gesture'
import { bindKeys } from './bind-keys'
import { bindPointer } from './bind-pointer'
import { Hand } from './hand'

/** Binds all that listens to the map: pointers and the wheel, keys, and the focus that shows its cursor. */
export function bindInput(host: HTMLElement, store: Store<State>, openHelp: () => void): void {
  const hand = new Hand(store)
  host.tabIndex = 0
  bindPointer(host, store, hand, bindFocus(host, store))
  bindGesture(host, store, hand)
  bindKeys(host, store, hand, openHelp)
}
