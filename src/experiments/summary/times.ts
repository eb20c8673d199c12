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
