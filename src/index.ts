export type { Param, ParamSettings, ParamValue } from './algorithms/params'
export { type Outcome, type PlanOptions, plan, plannerById } from './algorithms/plan'
export type { AnyPlanner, Planner } from './algorithms/planner'
export { planners } from './algorithms/planners'
export { bug1Bound, bug2Bound, type LengthBound, type ObstacleShare } from './experiments/bounds'
export { openResults } from './experiments/open-results'
export type { Results } from './experiments/results'
export { resultsToCsv } from './experiments/results-csv'
export { resultsToJson, resultsToLines } from './experiments/results-json'
export type { Row } from './experiments/row'
export { runMap } from './experiments/run-map'
export { countWork, type ExperimentSettings, plannerSettings } from './experiments/settings'
export { checkSettings, readSettings, saveSettings } from './experiments/settings-check'
export { type TestMap, testMap } from './experiments/test-map'
export { InputError } from './grid/errors'
export { type Cell, cellName, type Grid, type Point } from './grid/grid'
export { firstIllegalStep, measurePath, type PathMeasure } from './grid/path'
export { checkProblem, type Problem } from './grid/problem'
export type { DiagonalRule } from './grid/steps'
export { problemFromText, problemToText } from './grid/text-map'
export { KNOWN, SEARCH } from './trace/cell-state'
export {
  EVENT,
  EVENT_NAMES,
  type EventKind,
  LEAVES,
  type Leave,
  STATUSES,
  type Status,
} from './trace/events'
export { frameAt } from './trace/fold'
export { type Frame, isFelt, knownOf, searchOf } from './trace/frame'
export { Player } from './trace/player'
export { Tape, type TapeData } from './trace/tape'
