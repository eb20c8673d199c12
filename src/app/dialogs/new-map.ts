import { byId } from '../element'
import { emptyProblem, resizedProblem } from '../setup'
import type { State } from '../state'
import type { Store } from '../store'
import { changeMap } from '../transitions'
import { dialog, formOf } from './dialog'
import { sizeFields } from './size-fields'

/**
 * Binds the dialog for a new map; returns what opens it.
 * @param attempt runs what may refuse its input, and shows why
 */
export function newMapDialog(
  store: Store<State>,
  attempt: (action: () => void) => void,
): () => void {
  const element = dialog('new-dialog')
  const form = formOf(element)
  const size = sizeFields('new')
  byId('new-size', HTMLDivElement).append(...size.elements)

  form.addEventListener('submit', (event) => {
    const chosen = size.check()
    if (!chosen) return event.preventDefault()
    const { width, height } = chosen
    const keep = new FormData(form).get('keep') === 'keep'
    attempt(() =>
      store.update((state) => {
        const { problem } = state.setup
        const made = keep
          ? resizedProblem(problem, width, height)
          : emptyProblem(width, height, problem.diagonal)
        const text = `A map of ${width} × ${height} cells.`
        return changeMap(state, { ...state.setup, problem: made }, text)
      }),
    )
  })

  return () => {
    form.reset()
    size.show(store.state.setup.problem.grid)
    element.showModal()
  }
}
