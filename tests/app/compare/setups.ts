import { planners } from '../../../src/algorithms/planners'
import { comparedPlan } from '../../../src/app/compare/compared'
import type { ComparisonEntry } from '../../../src/app/compare/state'
import { optimumOf } from '../../../src/experiments/run-map'
import { setupFrom } from '../setups'

/** The goal lies straight ahead behind a wall, which the shortest path passes below. */
export const walled = setupFrom(`
  .........
  .S..#....
  ....#..G.
  ....#....
  .........
`)

/** What the comparing worker would find. */
export function entriesOf(setup = walled): ComparisonEntry[] {
  const optimum = optimumOf(setup.problem)
  return planners.map((planner) => {
    const plan = comparedPlan(setup, planner, optimum)
    return { subject: setup, plan, milliseconds: null }
  })
}
