import type { Row } from '../row'
import type { ExperimentSettings } from '../settings'
import { type Series, seriesOf } from './groups'
import { type Quantiles, quantilesOf } from './statistics'

/** The runs whose ratio is at least `from` and less than `to`. */
export interface Bin {
  readonly from: number
  readonly to: number
  readonly rows: readonly Row[]
}

/** How long the paths of the runs that succeeded are, compared with the optimum. */
export interface RatioDistribution {
  readonly rows: readonly Row[]
  /** Of the ratio; 1 is optimal. */
  readonly quantiles: Quantiles
  readonly bins: readonly Bin[]
}

const ALMOST_ONE = 1 + 1e-6

/** The first bin is for optimal paths only. */
export const RATIO_EDGES: readonly number[] = [
  1,
  ALMOST_ONE,
  ...[1.1, 1.2, 1.3, 1.5, 1.75, 2, 2.5, 3, 4, 6, 10],
  Number.POSITIVE_INFINITY,
]

/**
 * The ratio to the optimum, for each planner setting.
 * @param edges where bins begin and end, by size; ratios below the first are counted into it, because
 * they are 1 but for rounding
 */
export function ratioBySetting(
  settings: ExperimentSettings,
  rows: readonly Row[],
  edges: readonly number[] = RATIO_EDGES,
): Series<RatioDistribution>[] {
  return seriesOf(settings, rows, (own) => [distributionOf(own, edges)])
}

export function distributionOf(rows: readonly Row[], edges = RATIO_EDGES): RatioDistribution {
  const reached = rows.filter(({ ratio }) => ratio !== null)
  const bins = edges.slice(1).map((to, i) => ({ from: edges[i], to, rows: [] as Row[] }))
  for (const row of reached) bins.find(({ to }) => ratioOf(row) < to)?.rows.push(row)
  return { rows: reached, quantiles: quantilesOf(reached.map(ratioOf)), bins }
}

const ratioOf = ({ ratio }: Row): number => ratio ?? Number.NaN
