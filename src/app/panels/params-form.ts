import { defaultOf, type Param, type ParamValue } from '../../algorithms/params'
import type { AnyPlanner } from '../../algorithms/planner'
import { inThousands } from '../../grid/thousands'
import { plannerOf, type Setup, settingsOf, withParam } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { change, commit, edit } from '../state/transitions'
import { choiceField, numberField, switchField } from './fields'

/** The form of a planner's parameters, built from what it declares. */
export interface ParamsForm {
  readonly planner: AnyPlanner
  readonly elements: readonly HTMLElement[]
  show(setup: Setup): void
}

interface ParamRow {
  readonly element: HTMLElement
  show(setup: Setup): void
}

export function paramsForm(store: Store<State>): ParamsForm {
  const planner = plannerOf(store.state.setup)
  const rows = planner.params.map((param) => rowFor(store, planner.id, param))
  return {
    planner,
    elements: rows.map((row) => row.element),
    show: (setup) => {
      for (const row of rows) row.show(setup)
    },
  }
}

/** Writes to the planner that it was built for, even if another one has been chosen meanwhile. */
function rowFor(store: Store<State>, plannerId: string, param: Param): ParamRow {
  switch (param.kind) {
    case 'choice':
      return choiceRow(store, plannerId, param)
    case 'boolean':
      return switchRow(store, plannerId, param)
    default:
      return numberRow(store, plannerId, param)
  }
}

const idOf = (param: Param): string => `param-${param.name}`

const settingOf = (setup: Setup, param: Param): ParamValue =>
  settingsOf(setup)[param.name] ?? defaultOf(param, setup.problem)

function numberRow(
  store: Store<State>,
  plannerId: string,
  param: Extract<Param, { unit: string }>,
): ParamRow {
  const { name, default: usual } = param
  const isAutomatic = typeof usual === 'function'
  const inWords = (value: ParamValue) => inThousands(String(value))
  const automatic = (setup: Setup) => `${inWords(defaultOf(param, setup.problem))} (automatic)`
  const field = numberField(
    {
      ...param,
      id: idOf(param),
      ...(isAutomatic ? { automatic: automatic(store.state.setup) } : {}),
    },
    {
      edited: (value) =>
        store.update((state) => edit(state, withParam(state.setup, plannerId, name, value))),
      done: () =>
        store.update((state) =>
          commit(state, `${param.label}: ${inWords(settingOf(state.setup, param))}.`),
        ),
    },
  )
  return {
    element: field.element,
    show(setup) {
      const value = settingsOf(setup)[name]
      if (!isAutomatic) return field.show(Number(settingOf(setup, param)))
      field.setAutomatic(automatic(setup))
      field.show(typeof value === 'number' ? value : undefined)
    },
  }
}

function choiceRow(
  store: Store<State>,
  plannerId: string,
  param: Extract<Param, { kind: 'choice' }>,
): ParamRow {
  const field = choiceField({ ...param, id: idOf(param) }, (value) =>
    store.update((state) =>
      change(
        state,
        withParam(state.setup, plannerId, param.name, value),
        `${param.label}: ${value}.`,
      ),
    ),
  )
  return {
    element: field.element,
    show: (setup) => field.show(String(settingOf(setup, param))),
  }
}

function switchRow(
  store: Store<State>,
  plannerId: string,
  param: Extract<Param, { kind: 'boolean' }>,
): ParamRow {
  const field = switchField({ ...param, id: idOf(param) }, (on) =>
    store.update((state) =>
      change(
        state,
        withParam(state.setup, plannerId, param.name, on),
        `${param.label}: ${on ? 'on' : 'off'}.`,
      ),
    ),
  )
  return {
    element: field.element,
    show: (setup) => field.show(settingOf(setup, param) === true),
  }
}
