import { byId } from '../element'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { hideCursor, prefer } from '../state/transitions'

/**
 * Binds the line that greets newcomers; returns what shows a state in it.
 * @param closed called when the user closes it and the map gets its room
 */
export function hint(store: Store<State>, closed: () => void): (state: State) => void {
  const line = byId('hint', HTMLParagraphElement)
  byId('hint-close', HTMLButtonElement).addEventListener('click', ({ detail }) => {
    store.update((state) => prefer(state, { hint: false }))
    // The button is gone.
    byId('map', HTMLDivElement).focus()
    // Who pressed it with a pointer needs no cursor, to which Space and the arrows would belong.
    if (detail > 0) store.update((state) => hideCursor(state))
    closed()
  })
  return ({ preferences }) => {
    line.hidden = !preferences.hint
  }
}
