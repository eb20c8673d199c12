import { completeParams, type ParamSettings, type ParamValue } from '../../algorithms/params'
import { plannerById } from '../../algorithms/plan'
import type { AnyPlanner } from '../../algorithms/planner'
import type { Cell, Grid } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import type { DiagonalRule } from '../../grid/steps'

/**
 * All that decides a plan: what the user works on, what undo and redo go through, and what survives
 * a reload. A value; every edit makes a new one.
 */
export interface Setup {
  readonly problem: Problem
  readonly plannerId: string
  /** By planner: the parameters that were set by hand, the others have their defaults. */
  readonly params: Readonly<Record<string, ParamSettings>>
  readonly seed: number
}

export const plannerOf = (setup: Setup): AnyPlanner => plannerById(setup.plannerId)

/** The settings of the chosen planner. */
export const settingsOf = (setup: Setup): ParamSettings => setup.params[setup.plannerId] ?? {}

/** All values of the chosen planner's parameters, defaults included. */
export const valuesOf = (setup: Setup): Record<string, ParamValue> =>
  completeParams(plannerOf(setup), settingsOf(setup), setup.problem)

export function withGrid(setup: Setup, grid: Grid): Setup {
  return { ...setup, problem: { ...setup.problem, grid } }
}

export function withDiagonal(setup: Setup, diagonal: DiagonalRule): Setup {
  return { ...setup, problem: { ...setup.problem, diagonal } }
}

/** The start or the goal at another cell, which has to be free. */
export function withMark(setup: Setup, mark: 'start' | 'goal', cell: Cell): Setup {
  return { ...setup, problem: { ...setup.problem, [mark]: cell } }
}

/** A parameter of a planner set by hand, or given back to its default. */
export function withParam(
  setup: Setup,
  plannerId: string,
  name: string,
  value: ParamValue | undefined,
): Setup {
  const { [name]: _, ...others } = setup.params[plannerId] ?? {}
  const settings = value === undefined ? others : { ...others, [name]: value }
  return withSettings(setup, plannerId, settings)
}

/** All settings of a planner at once. */
export function withSettings(setup: Setup, plannerId: string, settings: ParamSettings): Setup {
  return { ...setup, params: { ...setup.params, [plannerId]: settings } }
}

/** Whether nothing was changed from one to the other; obstacles drawn anew count as a change. */
export function isSameSetup(a: Setup, b: Setup): boolean {
  const [p, q] = [a.problem, b.problem]
  return (
    p.grid === q.grid &&
    p.start === q.start &&
    p.goal === q.goal &&
    p.diagonal === q.diagonal &&
    a.plannerId === b.plannerId &&
    a.params === b.params &&
    a.seed === b.seed
  )
}
