import { byId, create, setText } from '../element'
import { plannerOf, type Setup, valuesOf } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import markup from './about-planner.html?raw'
import { newDialog } from './dialog'

const REPORT =
  'The report is A. Zini, F. Morselli and C. Stoemo, “Implementation and analysis of the main path planning techniques”.'

/** Makes the dialog that says what the chosen planner is; returns what opens it. */
export function aboutDialog(store: Store<State>): () => void {
  const element = newDialog('about-dialog', markup)
  const title = byId('about-title', HTMLHeadingElement)
  const body = byId('about-body', HTMLDivElement)
  return () => {
    const { setup } = store.state
    const planner = plannerOf(setup)
    setText(title, planner.title)
    body.replaceChildren(
      create('p', {}, planner.summary),
      create('h3', {}, 'What it promises'),
      create('p', {}, planner.promise),
      create('p', { class: 'promises' }, promisesInWords(setup)),
      create('h3', {}, 'How it works'),
      create(
        'ol',
        { class: 'pseudocode' },
        ...planner.pseudocode.map((line) => create('li', {}, create('code', {}, line))),
      ),
      create('h3', {}, 'Source'),
      create('p', {}, planner.source),
      create('p', { class: 'help' }, REPORT),
    )
    element.showModal()
    element.scrollTop = 0
  }
}

/** What holds under the present settings. */
export function promisesInWords(setup: Setup): string {
  const planner = plannerOf(setup)
  const values = valuesOf(setup)
  const complete = planner.complete(values)
    ? 'complete (it finds a path if there is one, and else proves that there is none)'
    : 'not complete (it may miss a path that exists)'
  const optimal = planner.optimal(values, setup.problem.diagonal)
    ? 'optimal (no path costs less)'
    : 'not optimal (a better path may exist)'
  return `With the present settings: ${complete}, and ${optimal}.`
}
