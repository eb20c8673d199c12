import { byId } from '../element'
import { emptyProblem, resizedProblem } from '../state/new-problem'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { attempt, changeMap } from '../state/transitions'
import { formOf, newDialog } from './dialog'
import markup from './new-map.html?raw'
import { sizeFields } from './size-fields'

/** Makes the dialog for a new map; returns what opens it. */
export function newMapDialog(store: Store<State>): () => void {
  const element = newDialog('new-dialog', markup)
  const form = formOf(element)
  const size = sizeFields('new')
  byId('new-size', HTMLDivElement).append(...size.elements)

  form.addEventListener('submit', (event) => {
    const chosen = size.check()
    if (!chosen) return event.preventDefault()
    const { width, height } = chosen
    const keep = new FormData(form).get('keep') === 'keep'
    const text = `A map of ${width} × ${height} cells.`
    const create = (state: State) => {
      const { problem } = state.setup
      const made = keep
        ? resizedProblem(problem, width, height)
        : emptyProblem(width, height, problem.diagonal)
      return changeMap(state, { ...state.setup, problem: made }, text)
    }
    store.update((state) => attempt(state, create))
  })

  return () => {
    form.reset()
    size.show(store.state.setup.problem.grid)
    element.showModal()
  }
}
