import { type Outcome, type ParamSettings, plan, plannerById, type Tape } from 'path-planner'
import type { Grid } from '../../src/grid/grid'
import { plan as planTapeless } from '../../src/index'
import { type Query, RULE } from './maps'

/**
 * One question to the built library, from a plain array of obstacles to the answer. It takes the array
 * as it is. What the planners keep of the map before they may use only once they have compared the
 * two maps cell by cell, even if they are the same array: that is counted.
 */
export const ask = asking(plan)

/** The same question to this library built as if there were no tapes: `withoutTape` sees to that. */
export const askTapeless = asking(planTapeless)

function asking(library: typeof plan) {
  return (
    grid: Grid,
    { start, goal }: Query,
    planner: string,
    params: ParamSettings,
    tape?: Tape,
  ): Outcome => {
    const problem = { grid, start, goal, diagonal: RULE } as const
    return library(problem, planner, tape ? { params, tape } : { params })
  }
}

/** The values that the parameter `search` of a planner may have, as it declares them. */
export function searchesOf(planner: string): readonly string[] {
  const param = plannerById(planner).params.find(({ name }) => name === 'search')
  if (param?.kind !== 'choice') throw new Error(`${planner} has no parameter search.`)
  return param.choices
}
