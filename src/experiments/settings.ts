import type { ParamValue } from '../algorithms/params'
import { plannerById } from '../algorithms/plan'
import type { Size } from '../grid/grid'
import type { DiagonalRule } from '../grid/steps'

/** The name and the version that settings files carry. */
export const SETTINGS_FORMAT = 'path-planner-experiment'
export const SETTINGS_VERSION = 1

/** The family of maps that are given in the settings as rows; all others are generators. */
export const GIVEN_MAPS = 'maps'

/** No experiment may ask for more runs: rather a message than a machine busy for weeks. */
export const MAX_RUNS = 10_000_000

/** For each parameter the values that it takes in turn; one that is missing has its default. */
export type ValueLists<Value> = Readonly<Record<string, readonly Value[]>>

export interface GivenMap {
  readonly name: string
  /** Rows of the map: `#` obstacle, `.` free. */
  readonly rows: readonly string[]
}

export interface Family {
  /** Id of a generator, or `maps`. */
  readonly family: string
  /** Of the generator: all combinations of these values are made. */
  readonly params: ValueLists<number>
  /** Of the family `maps` only. */
  readonly maps?: readonly GivenMap[] | undefined
}

export interface PlannerFamily {
  /** Id of a planner. */
  readonly planner: string
  /** All combinations of these values are run. */
  readonly params: ValueLists<ParamValue>
}

/**
 * What an experiment is: which maps and which planners with which parameters. A plain JSON value;
 * the same settings give the same rows everywhere, times aside.
 */
export interface ExperimentSettings {
  readonly format: typeof SETTINGS_FORMAT
  readonly version: typeof SETTINGS_VERSION
  /** A whole number from 0 to 2^31 - 1. */
  readonly seed: number
  readonly diagonal: DiagonalRule
  readonly families: readonly Family[]
  /** Width and height, in cells, of the maps of all generators. */
  readonly sizes: readonly (readonly [width: number, height: number])[]
  /** How many maps are made of each family, combination of its parameters, and size. */
  readonly mapsPerCombination: number
  /** Least number of steps of the simplest path from start to goal. */
  readonly leastDistance: number
  readonly planners: readonly PlannerFamily[]
}

/** A planner with one value for each of its lists. */
export interface PlannerSetting {
  readonly planner: string
  readonly params: Readonly<Record<string, ParamValue>>
}

/** A combination of what maps are made from. */
export interface MapKind {
  readonly family: string
  /** Parameters of the generator, or the number of the given map as `map`, counted from 0. */
  readonly params: Readonly<Record<string, number>>
  readonly size: Size
  /** The map itself, in the family `maps`. */
  readonly given?: GivenMap
}

/** All ways to choose one value from each list; the last list varies fastest. */
function combinations<Value>(lists: ValueLists<Value>): Record<string, Value>[] {
  let chosen: Record<string, Value>[] = [{}]
  for (const [name, values] of Object.entries(lists)) {
    chosen = chosen.flatMap((one) => values.map((value) => ({ ...one, [name]: value })))
  }
  return chosen
}

/** How many there are, without making them. */
function countCombinations(lists: ValueLists<unknown>): number {
  return Object.values(lists).reduce((product, values) => product * values.length, 1)
}

/** The planners as they are run on each map, in this order. */
export function plannerSettings({ planners }: ExperimentSettings): PlannerSetting[] {
  return planners.flatMap(({ planner, params }) =>
    combinations(params).map((chosen) => ({ planner, params: chosen })),
  )
}

/** What kinds of maps there are, in their order: given maps once each, generated ones in each size. */
export function mapKinds({ families, sizes }: ExperimentSettings): MapKind[] {
  return families.flatMap(({ family, params, maps }) =>
    family === GIVEN_MAPS
      ? (maps ?? []).map((given, map) => ({
          family,
          params: { map },
          size: { width: given.rows[0].length, height: given.rows.length },
          given,
        }))
      : combinations(params).flatMap((chosen) =>
          sizes.map(([width, height]) => ({ family, params: chosen, size: { width, height } })),
        ),
  )
}

/** How much work the settings ask for; counted without listing it. */
export function countWork(settings: ExperimentSettings): {
  readonly maps: number
  readonly settings: number
  readonly runs: number
} {
  const { families, sizes, planners, mapsPerCombination } = settings
  const sum = (numbers: number[]) => numbers.reduce((total, number) => total + number, 0)
  const kinds = families.map(({ family, params, maps }) =>
    family === GIVEN_MAPS ? (maps?.length ?? 0) : countCombinations(params) * sizes.length,
  )
  const maps = sum(kinds) * mapsPerCombination
  const each = sum(planners.map(({ params }) => countCombinations(params)))
  return { maps, settings: each, runs: maps * each }
}

/** A planner setting in a few words: "Bug2 (leave closer)". */
export function settingName({ planner, params }: PlannerSetting): string {
  const { title } = plannerById(planner)
  const values = Object.entries(params).map(([name, value]) => `${name} ${value}`)
  return values.length === 0 ? title : `${title} (${values.join(', ')})`
}
