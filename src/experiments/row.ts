import type { ParamValue } from '../algorithms/params'
import type { Status } from '../trace/events'

/** So many rows are read or written within a fraction of a frame. */
export const ROWS_AT_ONCE = 64

type Place = readonly [x: number, y: number]

/**
 * What came of one planner setting on one map. All but `milliseconds` follows from the settings of
 * the experiment, on every machine.
 */
export interface Row {
  /** Number of the map, from 0. */
  readonly map: number
  /** Generator that made the map, or `maps`. */
  readonly family: string
  readonly mapParams: Readonly<Record<string, number>>
  readonly width: number
  readonly height: number
  /** Share of the cells that are obstacles, in percent, to two decimals. */
  readonly density: number
  readonly mapSeed: number
  readonly start: Place
  readonly goal: Place
  /** Steps of the simplest path from start to goal. */
  readonly distance: number
  /** No start and goal were found as far apart as was asked for. */
  readonly tooNear: boolean
  readonly reachable: boolean
  /** Least number of cells of a path, both ends included; `null` if there is no path. */
  readonly optimumCells: number | null
  /** Least Euclidean length of a path, in cell sides; `null` if there is no path. */
  readonly optimumLength: number | null
  /** Number of the planner setting, from 0. */
  readonly setting: number
  readonly planner: string
  /** All its parameters, those that the settings do not name with their defaults. */
  readonly params: Readonly<Record<string, ParamValue>>
  readonly seed: number
  readonly status: Status
  /** Cells of the path, or of the way walked so far; both ends included. */
  readonly cells: number
  /** Its Euclidean length, in cell sides. */
  readonly length: number
  readonly turns: number
  /** Steps of it: what a rover walked. */
  readonly steps: number
  /**
   * What the path cost, divided by the least cost there is: the competitive ratio of online planners.
   * Cost is the number of steps, or the Euclidean length if the parameter `cost` says so; `null`
   * unless the goal was reached.
   */
  readonly ratio: number | null
  readonly expanded: number
  readonly sensed: number
  /** Steps that Bug1, or Bug2 with `closer`, may walk at most (see `bounds.ts`); else `null`. */
  readonly bound: number | null
  /** Time to plan; 0 if no clock ticked meanwhile. The only value that another run may change. */
  readonly milliseconds: number
}

/** Whether the planner found a way; of interest where `reachable`. */
export const isSuccess = ({ status }: Row): boolean => status === 'reached'
