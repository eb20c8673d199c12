import { byId } from '../element'
import type { State } from '../state'
import type { Store } from '../store'
import { prefer } from '../transitions'

/**
 * Binds the line that greets newcomers; returns what shows a state in it.
 * @param closed called when the user closes it and the map gets its room
 */
export function hint(store: Store<State>, closed: () => void): (state: State) => void {
  const line = byId('hint', HTMLParagraphElement)
  byId('hint-close', HTMLButtonElement).addEventListener('click', () => {
    store.update((state) => prefer(state, { hint: false }))
    byId('map', HTMLDivElement).focus()
    closed()
  })
  return ({ preferences }) => {
    line.hidden = !preferences.hint
  }
}
