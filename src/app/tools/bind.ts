import type { State } from '../state/state'
import type { Store } from '../state/store'
import { bindFocus } from './bind-focus'
import { bindKeys } from './bind-keys'
import { bindPointer } from './bind-pointer'
import { Hand } from './hand'

/** Binds pointers, wheel and keys to the map: all that listens to the map is here. */
export function bindInput(host: HTMLElement, store: Store<State>, openHelp: () => void): void {
  const hand = new Hand(store)
  host.tabIndex = 0
  bindPointer(host, store, hand, bindFocus(host, store))
  bindKeys(host, store, hand, openHelp)
}
