import type { Row } from '../row'
import type { ExperimentSettings } from '../settings'
import { groupBy, type Series, seriesOf } from './groups'
import { type Quantiles, quantilesOf } from './statistics'

export interface TimePoint {
  readonly width: number
  readonly height: number
  /** Of the map: `width * height`. */
  readonly cells: number
  readonly rows: readonly Row[]
  readonly milliseconds: Quantiles
}

/**
 * How long a tick of the clock is at most that the times were read off, in milliseconds: the least of
 * them that is not 0. Those that are 0 were less. If all are, the tick is not known, and 0.
 */
export function clockTick(rows: readonly Row[]): number {
  let tick = Number.POSITIVE_INFINITY
  for (const { milliseconds } of rows) {
    if (milliseconds > 0 && milliseconds < tick) tick = milliseconds
  }
  return tick < Number.POSITIVE_INFINITY ? tick : 0
}

/**
 * About how long runs take that are shorter than a tick: as the clock starts anywhere in a tick, it ticks
 * in as large a share of the runs as they are of a tick. A few slow runs do not change that.
 */
export function estimateBelowTick(rows: readonly Row[], tick: number): number {
  const ticked = rows.filter(({ milliseconds }) => milliseconds > 0)
  return (tick * ticked.length) / rows.length
}

/** Time to plan over the size of the map, a line for each planner setting; by increasing size. */
export function timeBySize(
  settings: ExperimentSettings,
  rows: readonly Row[],
): Series<TimePoint>[] {
  return seriesOf(settings, rows, (own) =>
    [...groupBy(own, ({ width, height }) => `${width} × ${height}`).values()]
      .map((group) => ({
        width: group[0].width,
        height: group[0].height,
        cells: group[0].width * group[0].height,
        rows: group,
        milliseconds: quantilesOf(group.map(({ milliseconds }) => milliseconds)),
      }))
      .sort((a, b) => a.cells - b.cells),
  )
}
