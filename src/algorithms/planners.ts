import { bug1 } from './bug1'
import { bug2 } from './bug2'
import { decomposition } from './decomposition'
import type { AnyPlanner } from './planner'
import { potentialField } from './potential-field'
import { potentialFieldMemory } from './potential-field-memory'
import { probabilisticRoadmap } from './probabilistic-roadmap'
import { tangentBug } from './tangent-bug'
import { visibilityGraph } from './visibility-graph'

/** All planners, in the report's order. */
export const planners: readonly AnyPlanner[] = [
  decomposition,
  visibilityGraph,
  probabilisticRoadmap,
  potentialField,
  potentialFieldMemory,
  bug1,
  bug2,
  tangentBug,
]
