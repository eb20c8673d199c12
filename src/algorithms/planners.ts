import { decomposition } from './decomposition'
import type { AnyPlanner } from './planner'

/** All planners, in the report's order. */
export const planners: readonly AnyPlanner[] = [decomposition]
