import type { Problem } from '../grid/problem'
import type { DiagonalRule } from '../grid/steps'
import type { DriveNotes } from '../rover/drive-notes'
import type { Rover, SensorSettings } from '../rover/rover'
import type { Status } from '../trace/events'
import type { Tape } from '../trace/tape'
import type { Param, ParamValue, ValuesOf } from './params'

/** What a planner answers; the path's cost and measures are reckoned for all planners in `plan`. */
export interface Answer {
  readonly status: Status
  /** One sentence: how it ended, or what the proof is. */
  readonly reason: string
  /** The path found, or the cells walked so far. */
  readonly path: Int32Array
  /** Cells (or roadmap vertices) whose shortest path became final; 0 for planners without search. */
  readonly expanded: number
}

/** What a planner is handed beside the problem or the rover. */
export interface Context<Values> {
  readonly params: Values
  /** Seeded: numbers from 0 up to 1, the same for the same seed. */
  readonly random: () => number
  readonly tape: Tape | undefined
  /** To be called now and then by work that may take long; `done` from 0 to 1. */
  readonly progress: (done: number) => void
}

/** What an online planner is handed beside its rover. The notes are for writing only. */
export interface DriveContext<Values> {
  readonly params: Values
  readonly notes: DriveNotes
}

export type Values = Readonly<Record<string, ParamValue>>

/** What is declared of a planner, of whichever family. */
export interface Planner {
  readonly id: string
  readonly title: string
  readonly family: 'offline' | 'online'
  /** What it does, in one or two sentences. */
  readonly summary: string
  /** What it promises and what it does not, in one or two sentences. */
  readonly promise: string
  /** Whether it finds a path whenever there is one, and else proves that there is none. */
  complete(params: Values): boolean
  /** Whether its paths are always of least cost. */
  optimal(params: Values, diagonal: DiagonalRule): boolean
  readonly params: readonly Param[]
  /** Names of the parts of its work; `phase` events on the tape count them from 0. */
  readonly phases: readonly string[]
  /** Names of the numbers that it decides by; `value` events on the tape count them from 0. */
  readonly variables: readonly string[]
  /** Whether chance plays a part, so that another seed may give another answer. */
  readonly usesSeed: boolean
  /** One string a line; events on the tape name these lines, counted from 0. */
  readonly pseudocode: readonly string[]
  /** Citation: the report's section, the paper. */
  readonly source: string
}

/** Sees the whole map. */
export interface OfflinePlanner extends Planner {
  readonly family: 'offline'
  plan(problem: Problem, context: Context<Values>): Answer
}

/** Sees only what its rover senses: nothing that it is given leads to the map. */
export interface OnlinePlanner extends Planner {
  readonly family: 'online'
  sensor(params: Values): SensorSettings
  drive(rover: Rover, context: DriveContext<Values>): DriveAnswer
}

/** The path of an online planner is the rover's trail, so it only says how the drive ended. */
export type DriveAnswer = Pick<Answer, 'status' | 'reason'>

/** A planner; its `family` tells which kind. */
export type AnyPlanner = OfflinePlanner | OnlinePlanner

type Described<Params extends readonly Param[]> = Omit<
  Planner,
  'family' | 'params' | 'usesSeed' | 'variables' | 'phases' | 'complete' | 'optimal'
> & {
  readonly params: Params
  readonly usesSeed?: true
  readonly variables?: readonly string[]
  readonly phases?: readonly string[]
  complete(params: ValuesOf<Params>): boolean
  optimal(params: ValuesOf<Params>, diagonal: DiagonalRule): boolean
}

/** What a planner has of the properties that it need not declare. */
const UNLESS_DECLARED = { usesSeed: false, variables: [], phases: [] } as const

/** Declares an offline planner; inside it the parameters have the types that it declares. */
export function offlinePlanner<const Params extends readonly Param[]>(
  planner: Described<Params> & {
    plan(problem: Problem, context: Context<ValuesOf<Params>>): Answer
  },
): OfflinePlanner {
  return { family: 'offline', ...UNLESS_DECLARED, ...planner } as OfflinePlanner
}

/** Declares an online planner; inside it the parameters have the types that it declares. */
export function onlinePlanner<const Params extends readonly Param[]>(
  planner: Described<Params> & {
    sensor(params: ValuesOf<Params>): SensorSettings
    drive(rover: Rover, context: DriveContext<ValuesOf<Params>>): DriveAnswer
  },
): OnlinePlanner {
  return { family: 'online', ...UNLESS_DECLARED, ...planner } as OnlinePlanner
}
