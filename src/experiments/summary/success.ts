import { isSuccess, type Row } from '../row'
import type { ExperimentSettings } from '../settings'
import { groupByNumber, type Series, seriesOf } from './groups'
import { type Share, wilson } from './statistics'

/** How often a goal that can be reached was reached, and by which runs not. */
export interface Success extends Share {
  /** The runs on maps whose goal can be reached. */
  readonly rows: readonly Row[]
  readonly failures: readonly Row[]
}

/** Runs on maps whose goal cannot be reached are left out: nobody could succeed there. */
export function successOf(rows: readonly Row[]): Success {
  const possible = rows.filter(({ reachable }) => reachable)
  const failures = possible.filter((row) => !isSuccess(row))
  return { rows: possible, failures, ...wilson(possible.length - failures.length, possible.length) }
}

export interface DensityPoint {
  /** In percent. */
  readonly density: number
  readonly success: Success
}

/** Success over the density of obstacles, a line for each planner setting. */
export function successByDensity(
  settings: ExperimentSettings,
  rows: readonly Row[],
): Series<DensityPoint>[] {
  return seriesOf(settings, rows, (own) =>
    groupByNumber(own, densityClass).map(([density, group]) => ({
      density,
      success: successOf(group),
    })),
  )
}

/** The density that the generator was asked for or, of other maps, theirs to the nearest 5 %. */
export function densityClass({ mapParams, density }: Row): number {
  return mapParams.density ?? 5 * Math.round(density / 5)
}
