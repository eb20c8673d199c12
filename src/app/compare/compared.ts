import { completeParams, type ParamSettings } from '../../algorithms/params'
import { plan } from '../../algorithms/plan'
import type { AnyPlanner } from '../../algorithms/planner'
import { bug2Bound } from '../../experiments/bounds'
import { boundOf, type Optimum, ratioToOptimum } from '../../experiments/run-map'
import { messageOf } from '../../grid/errors'
import type { Status } from '../../trace/events'
import type { Setup } from '../state/setup'

/** What planners are compared on: a setup, whichever planner is chosen in it. */
export type Subject = Pick<Setup, 'problem' | 'params' | 'seed'>

export const isSameSubject = (a: Subject, b: Subject): boolean =>
  a.problem === b.problem && a.params === b.params && a.seed === b.seed

/** What came of one planner. */
export interface ComparedPlan {
  readonly plannerId: string
  /** `refused` if the parameters as set do not fit the map. */
  readonly status: Status | 'refused'
  readonly reason: string
  /** From start to goal, or as far as the planner came. */
  readonly path: Int32Array
  readonly cells: number
  /** Euclidean, in cell sides. */
  readonly length: number
  readonly turns: number
  /** Cells (or vertices) expanded; of planners with a rover cells sensed. */
  readonly effort: number
  /** Steps of `path`. */
  readonly walked: number
  /** Cost over the optimum under the planner's own rule; `null` unless the goal was reached. */
  readonly ratio: number | null
  readonly ratioBy: 'cells' | 'length'
  /** Lumelsky and Stepanov's bound on the steps of Bug1 and Bug2; `null` for the others. */
  readonly bound: number | null
  /** Whether that is promised: of Bug2 with `closer` only. */
  readonly isBoundHeld: boolean
  /** How long this one run took. */
  readonly milliseconds: number
}

const settingsFor = ({ params }: Subject, planner: AnyPlanner): ParamSettings =>
  params[planner.id] ?? {}

/** Runs a planner as it is set, without a tape. */
export function runPlanner(subject: Subject, planner: AnyPlanner) {
  const params = settingsFor(subject, planner)
  return plan(subject.problem, planner.id, { params, seed: subject.seed })
}

export function comparedPlan(
  subject: Subject,
  planner: AnyPlanner,
  optimum: Optimum,
): ComparedPlan {
  try {
    return reportOf(subject, planner, optimum)
  } catch (error) {
    return { ...NOTHING, plannerId: planner.id, reason: messageOf(error) }
  }
}

const NOTHING = {
  status: 'refused',
  path: new Int32Array(0),
  cells: 0,
  length: 0,
  turns: 0,
  effort: 0,
  walked: 0,
  ratio: null,
  ratioBy: 'cells',
  bound: null,
  isBoundHeld: false,
  milliseconds: 0,
} as const

function reportOf(subject: Subject, planner: AnyPlanner, optimum: Optimum): ComparedPlan {
  const { problem } = subject
  const params = completeParams(planner, settingsFor(subject, planner), problem)
  const began = performance.now()
  const outcome = runPlanner(subject, planner)
  const milliseconds = performance.now() - began
  const { status, reason, path, measure, expanded, sensed } = outcome
  const promised = boundOf(problem, planner.id, params)
  const byLength = params.cost === 'euclidean'
  return {
    plannerId: planner.id,
    status,
    reason,
    path,
    ...measure,
    effort: planner.family === 'online' ? sensed : expanded,
    walked: Math.max(0, path.length - 1),
    ratio: ratioToOptimum(outcome, byLength, optimum),
    ratioBy: byLength ? 'length' : 'cells',
    bound: promised ?? (planner.id === 'bug2' ? bug2Bound(problem).steps : null),
    isBoundHeld: promised !== null,
    milliseconds,
  }
}
