import type { ParamSettings } from 'path-planner'
import { quantilesOf } from '../../src/experiments/summary/statistics'
import { acrossAll, type BenchMap, generatedMap } from './maps'
import { ask, searchesOf } from './ours'
import { timeAlone } from './timing'

/** A planner whose time is measured over the size of the map. */
interface Grower {
  readonly name: string
  readonly planner: string
  readonly params: ParamSettings
  /** Whether its time must grow with the cells and hardly faster. */
  readonly isLinear: boolean
}

/** The times of one planner on all maps of a size, in ms. */
interface GrowthPoint {
  readonly side: number
  readonly least: number
  readonly median: number
  readonly greatest: number
}

export interface Growth {
  readonly grower: Grower
  readonly points: readonly GrowthPoint[]
  /** The time grows with this power of the number of cells. */
  readonly exponent: number
}

/** Each has twice as many cells as the one before. */
const SIDES = Array.from({ length: 11 }, (_, i) => Math.round(64 * 2 ** (i / 2)))
const SEEDS = [1, 2, 3]

/** A doubling of the cells may take so many times as long where it has to be linear. */
export const MOST_A_DOUBLING = 2.3

const grower = (planner: string, params: ParamSettings, words = ''): Grower => ({
  name: `${planner} ${words}`.trim(),
  planner,
  params,
  isLinear: planner === 'potential-field' || (planner === 'decomposition' && words === 'dijkstra'),
})

const searching = (planner: string): Grower[] =>
  searchesOf(planner).map((search) => grower(planner, { cost: 'euclidean', search }, search))

/** Planners that search a graph. */
export const searchers: readonly Grower[] = [
  ...searching('decomposition'),
  ...searching('visibility-graph'),
  ...searching('probabilistic-roadmap'),
]

/** Planners that walk by what they see around them, and the fields that two of them need for it. */
export const walkers: readonly Grower[] = [
  grower('potential-field', {}),
  grower('potential-field-memory', {}),
  grower('bug1', {}),
  grower('bug2', { leave: 'closer' }, 'closer'),
  grower('tangent-bug', { variant: 'classic' }, 'classic'),
]

export const growers: readonly Grower[] = [...searchers, ...walkers]

/** A planner that takes longer is not asked for larger maps. */
const MOST_MS = 2000

/** Times planners on random maps of all sizes, from one end of what can be reached to the other. */
export function measureGrowth(growers: readonly Grower[]): Growth[] {
  const points = new Map<Grower, GrowthPoint[]>(growers.map((one) => [one, []]))
  for (const side of SIDES) {
    const maps = SEEDS.map((seed) => generatedMap('random', { width: side, height: side }, seed, 1))
    for (const [one, own] of points) {
      const before = own[own.length - 1]
      if (before && before.median > MOST_MS) continue
      const { least, median, greatest } = quantilesOf(maps.map((map) => timeOn(map, one)))
      own.push({ side, least, median, greatest })
    }
  }
  return [...points].map(([one, own]) => ({ grower: one, points: own, exponent: exponentOf(own) }))
}

function timeOn({ grid, queries }: BenchMap, { planner, params }: Grower): number {
  const query = acrossAll(grid, queries[0].start)
  return timeAlone(() => {
    ask(grid, query, planner, params)
    return 1
  })
}

/** The slope of the line through the logarithms of cells and times that fits best. */
export function exponentOf(points: readonly Pick<GrowthPoint, 'side' | 'median'>[]): number {
  const x = points.map(({ side }) => Math.log(side * side))
  const y = points.map(({ median }) => Math.log(median))
  const mean = (values: readonly number[]) => values.reduce((a, b) => a + b, 0) / values.length
  const [middleX, middleY] = [mean(x), mean(y)]
  const along = x.reduce((sum, value, i) => sum + (value - middleX) * (y[i] - middleY), 0)
  return along / x.reduce((sum, value) => sum + (value - middleX) ** 2, 0)
}

/** How many times as long a map takes that has twice as many cells. */
export const aDoubling = ({ exponent }: Growth): number => 2 ** exponent

export const isGrowthMet = (growth: Growth): boolean =>
  !growth.grower.isLinear || aDoubling(growth) <= MOST_A_DOUBLING
