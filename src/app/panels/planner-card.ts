import { planners } from '../../algorithms/planners'
import { MAX_SEED } from '../../grid/random'
import { DIAGONAL_RULES } from '../../grid/steps'
import { byId, create, setText } from '../element'
import { plannerOf, type Setup, withDiagonal, withSettings } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { change, commit, edit, prefer } from '../state/transitions'
import { DIAGONAL_RULE_WORDS } from '../words/diagonal-rules'
import { numberField, switchField } from './fields'
import { type ParamsForm, paramsForm } from './params-form'

const FAMILIES = [
  { family: 'offline', title: 'Sees the whole map' },
  { family: 'online', title: 'Senses as it goes' },
] as const

/** Binds the planner card; returns what shows a state in it. */
export function plannerCard(store: Store<State>, openAbout: () => void): (state: State) => void {
  const title = byId('planner-title', HTMLSpanElement)
  const select = byId('planner-select', HTMLSelectElement)
  const summary = byId('planner-summary', HTMLParagraphElement)
  const params = byId('planner-params', HTMLDivElement)
  const diagonal = byId('diagonal', HTMLSelectElement)
  const diagonalHelp = byId('diagonal-help', HTMLParagraphElement)
  const reset = byId('planner-reset', HTMLButtonElement)
  let form: ParamsForm | null = null

  for (const { family, title: name } of FAMILIES) {
    const group = create('optgroup', { label: name })
    for (const planner of planners.filter((candidate) => candidate.family === family)) {
      group.append(create('option', { value: planner.id }, planner.title))
    }
    select.append(group)
  }
  for (const rule of DIAGONAL_RULES) {
    diagonal.append(create('option', { value: rule }, DIAGONAL_RULE_WORDS[rule].title))
  }

  const seed = numberField(
    {
      id: 'seed',
      kind: 'integer',
      label: 'Seed',
      unit: '',
      min: 0,
      max: MAX_SEED,
      help: 'Decides what is drawn by lot: the same seed gives the same plan.',
    },
    {
      edited: (value) =>
        store.update((state) =>
          value === undefined ? state : edit(state, { ...state.setup, seed: value }),
        ),
      done: () => store.update((state) => commit(state, `Seed: ${state.setup.seed}.`)),
    },
  )
  byId('seed-field', HTMLDivElement).append(seed.element)

  const potential = switchField(
    {
      id: 'show-potential',
      label: 'Show potentials',
      help: 'As colours, and as numbers where cells are large enough.',
    },
    (on) => store.update((state) => prefer(state, { showPotential: on })),
  )
  byId('potential-field', HTMLDivElement).append(potential.element)

  select.addEventListener('change', () => {
    const plannerId = select.value
    store.update((state) => {
      const setup = { ...state.setup, plannerId }
      return change(state, setup, `Planner: ${plannerOf(setup).title}.`)
    })
  })
  diagonal.addEventListener('change', () => {
    const rule = DIAGONAL_RULES.find((name) => name === diagonal.value)
    if (!rule) return
    const text = `Diagonal steps: ${DIAGONAL_RULE_WORDS[rule].title}.`
    store.update((state) => change(state, withDiagonal(state.setup, rule), text))
  })
  reset.addEventListener('click', () => {
    form = null
    store.update((state) =>
      change(state, resetSetup(state.setup), 'The parameters have their defaults again.'),
    )
    show(store.state)
  })
  byId('planner-about', HTMLButtonElement).addEventListener('click', openAbout)

  function show(state: State): void {
    const { setup, shown, preferences } = state
    const planner = plannerOf(setup)
    if (form?.planner !== planner) {
      form = paramsForm(store)
      const hadFocus = params.contains(document.activeElement)
      params.replaceChildren(...form.elements)
      // As when undo leads from a parameter to another planner.
      if (hadFocus) select.focus()
      seed.element.hidden = !planner.usesSeed
      reset.hidden = planner.params.length === 0 && !planner.usesSeed
    }
    form.show(setup)
    seed.show(setup.seed)
    setText(title, planner.title)
    setText(summary, planner.summary)
    select.value = planner.id
    diagonal.value = setup.problem.diagonal
    setText(diagonalHelp, DIAGONAL_RULE_WORDS[setup.problem.diagonal].help)
    const hasPotential =
      shown?.setup.plannerId === setup.plannerId && shown.last.fields.potential !== null
    potential.element.hidden = !hasPotential
    potential.show(preferences.showPotential)
  }
  return show
}

/** The seed belongs to the settings of planners that use it. */
function resetSetup(setup: Setup): Setup {
  const reset = withSettings(setup, setup.plannerId, {})
  return plannerOf(setup).usesSeed ? { ...reset, seed: 1 } : reset
}
