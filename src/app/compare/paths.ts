import { planners } from '../../algorithms/planners'
import { isSameSize } from '../../grid/grid'
import { type PathStyle, pathStyles, type StyledPath } from '../../render/path-styles'
import type { State } from '../state/state'

/** The style of a planner's path, the same wherever it is shown. */
export function styleOf(plannerId: string): PathStyle {
  const place = planners.findIndex(({ id }) => id === plannerId)
  return pathStyles[place % pathStyles.length]
}

/** The paths to be drawn; those of an earlier map only if it had this size. */
export function comparedPaths({ comparison, setup }: State): readonly StyledPath[] {
  return comparison.entries
    .filter(({ plan, subject }) => {
      const fits = isSameSize(subject.problem.grid, setup.problem.grid)
      return fits && plan.path.length > 1 && !comparison.hidden.includes(plan.plannerId)
    })
    .map(({ plan: { path, plannerId } }) => ({ path, style: styleOf(plannerId) }))
}
