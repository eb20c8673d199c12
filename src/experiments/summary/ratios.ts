import type { Row } from '../row'
import type { ExperimentSettings } from '../settings'
import { type Series, seriesOf } from './groups'
import { type Quantiles, quantilesOf } from './statistics'

/** How long the paths of the runs that succeeded are, compared with the optimum. */
export interface RatioDistribution {
  readonly rows: readonly Row[]
  /** Of the ratio; 1 is optimal. */
  readonly quantiles: Quantiles
  /** Those of the rows whose path is optimal. */
  readonly optimal: readonly Row[]
}

/** Rows have ratios to six decimals. */
const ALMOST_ONE = 1 + 1e-6

/** The ratio to the optimum, for each planner setting. */
export const ratioBySetting = (
  settings: ExperimentSettings,
  rows: readonly Row[],
): Series<RatioDistribution>[] => seriesOf(settings, rows, (own) => [distributionOf(own)])

export function distributionOf(rows: readonly Row[]): RatioDistribution {
  const reached = rows.filter(({ ratio }) => ratio !== null)
  const optimal = reached.filter((row) => ratioOf(row) < ALMOST_ONE)
  return { rows: reached, quantiles: quantilesOf(reached.map(ratioOf)), optimal }
}

const ratioOf = ({ ratio }: Row): number => ratio ?? Number.NaN
