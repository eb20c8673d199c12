import type { Row } from '../row'
import { groupBy, groupByNumber } from './groups'
import { distributionOf, type RatioDistribution } from './ratios'
import { type Quantiles, quantilesOf } from './statistics'
import { type Success, successOf } from './success'

export interface SamplesPoint {
  readonly samples: number
  readonly success: Success
  readonly ratio: RatioDistribution
  readonly milliseconds: Quantiles
}

export interface SamplesCurve {
  /** What its runs have in common beside the samples: "search dijkstra, cost cells". */
  readonly name: string
  readonly points: readonly SamplesPoint[]
}

/**
 * The trade-off of probabilistic roadmaps: with more samples a way is found more often and is
 * shorter, and finding it takes longer. A curve for each combination of the other parameters.
 */
export function roadmapBySamples(rows: readonly Row[]): SamplesCurve[] {
  const roadmaps = rows.filter(({ planner }) => planner === 'probabilistic-roadmap')
  return [...groupBy(roadmaps, otherParams)].map(([name, own]) => ({
    name,
    points: groupByNumber(own, ({ params }) => Number(params.samples)).map(([samples, group]) => ({
      samples,
      success: successOf(group),
      ratio: distributionOf(group),
      milliseconds: quantilesOf(group.map(({ milliseconds }) => milliseconds)),
    })),
  }))
}

const otherParams = ({ params }: Row): string =>
  Object.entries(params)
    .filter(([name]) => name !== 'samples')
    .map(([name, value]) => `${name} ${value}`)
    .join(', ')
