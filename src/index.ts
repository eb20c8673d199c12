export type { Turn } from './algorithms/boundary'
export type {
  BooleanParam,
  ChoiceParam,
  IntegerParam,
  NumberParam,
  Param,
  ParamSettings,
  ParamValue,
} from './algorithms/params'
export { type Outcome, type PlanOptions, plan, plannerById } from './algorithms/plan'
export type {
  Answer,
  AnyPlanner,
  Context,
  DriveAnswer,
  DriveContext,
  OfflinePlanner,
  OnlinePlanner,
  Planner,
  Values,
} from './algorithms/planner'
export { planners } from './algorithms/planners'
export { bug1Bound, bug2Bound, type LengthBound, type ObstacleShare } from './experiments/bounds'
export { openResults } from './experiments/open-results'
export type { Origin, Results } from './experiments/results'
export { resultsToCsv } from './experiments/results-csv'
export { resultsToJson, resultsToLines } from './experiments/results-json'
export type { Row } from './experiments/row'
export { runMap } from './experiments/run-map'
export {
  countWork,
  type ExperimentSettings,
  type Family,
  type GivenMap,
  type MapKind,
  type PlannerFamily,
  type PlannerSetting,
  plannerSettings,
  type ValueLists,
} from './experiments/settings'
export { checkSettings, readSettings, saveSettings } from './experiments/settings-check'
export type { Shard } from './experiments/shards'
export { type TestMap, testMap } from './experiments/test-map'
export type { Direction } from './grid/directions'
export { InputError } from './grid/errors'
export { type Cell, cellName, type Grid, type Point, type Size } from './grid/grid'
export { firstIllegalStep, measurePath, type PathMeasure } from './grid/path'
export { checkProblem, type Problem } from './grid/problem'
export type { DiagonalRule, Directions } from './grid/steps'
export { problemFromText, problemToText } from './grid/text-map'
export type { DriveNotes } from './rover/drive-notes'
export type { Knowledge, Rover, SensorSettings } from './rover/rover'
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
export {
  type CellList,
  type Estimate,
  type Field,
  type Frame,
  isFelt,
  knownOf,
  type Refusal,
  searchOf,
  type Test,
} from './trace/frame'
export { Player } from './trace/player'
export { Tape, type TapeData } from './trace/tape'
export type { Thinning } from './trace/thinning'
