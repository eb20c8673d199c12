import { defaultOf, type Param, type ParamValue } from '../../algorithms/params'
import type { AnyPlanner } from '../../algorithms/planner'
import { plannerOf, type Setup, settingsOf, withParam } from '../setup'
import type { State } from '../state'
import type { Store } from '../store'
import { change, commit, edit } from '../transitions'
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
  const rows = planner.params.map((param) => rowFor(store, param))
  return {
    planner,
    elements: rows.map((row) => row.element),
    show: (setup) => {
      for (const row of rows) row.show(setup)
    },
  }
}

function rowFor(store: Store<State>, param: Param): ParamRow {
  switch (param.kind) {
    case 'choice':
      return choiceRow(store, param)
    case 'boolean':
      return switchRow(store, param)
    default:
      return numberRow(store, param)
  }
}

const idOf = (param: Param): string => `param-${param.name}`

const settingOf = (setup: Setup, param: Param): ParamValue =>
  settingsOf(setup)[param.name] ?? defaultOf(param, setup.problem)

function numberRow(store: Store<State>, param: Extract<Param, { unit: string }>): ParamRow {
  const { name, default: usual } = param
  const isAutomatic = typeof usual === 'function'
  const automatic = (setup: Setup) => `${defaultOf(param, setup.problem)} (automatic)`
  const field = numberField(
    {
      ...param,
      id: idOf(param),
      ...(isAutomatic ? { automatic: automatic(store.state.setup) } : {}),
    },
    {
      edited: (value) => store.update((state) => edit(state, withParam(state.setup, name, value))),
      done: () =>
        store.update((state) => commit(state, `${param.label}: ${settingOf(state.setup, param)}.`)),
    },
  )
  return {
    element: field.element,
    show(setup) {
      const value = settingsOf(setup)[name]
      if (isAutomatic) field.setAutomatic(automatic(setup))
      else field.show(Number(settingOf(setup, param)))
      if (isAutomatic) field.show(typeof value === 'number' ? value : undefined)
    },
  }
}

function choiceRow(store: Store<State>, param: Extract<Param, { kind: 'choice' }>): ParamRow {
  const field = choiceField({ ...param, id: idOf(param) }, (value) =>
    store.update((state) =>
      change(state, withParam(state.setup, param.name, value), `${param.label}: ${value}.`),
    ),
  )
  return {
    element: field.element,
    show: (setup) => field.show(String(settingOf(setup, param))),
  }
}

function switchRow(store: Store<State>, param: Extract<Param, { kind: 'boolean' }>): ParamRow {
  const field = switchField({ ...param, id: idOf(param) }, (on) =>
    store.update((state) =>
      change(
        state,
        withParam(state.setup, param.name, on),
        `${param.label}: ${on ? 'on' : 'off'}.`,
      ),
    ),
  )
  return {
    element: field.element,
    show: (setup) => field.show(settingOf(setup, param) === true),
  }
}
