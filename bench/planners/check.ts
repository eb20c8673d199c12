import type { Cell, Grid } from '../../src/grid/grid'
import type { BenchMap, Query } from './maps'
import { ask, askTapeless, searchesOf } from './ours'
import type { Peer } from './peers/peer'
import { leastCost } from './plain/dijkstra'
import { costOfPath } from './plain/steps'

/** An answer that is no shortest path. */
export interface Fault {
  readonly who: string
  readonly isOurs: boolean
  readonly map: BenchMap
  readonly query: Query
  /** Cost of the answer; NaN if it is no legal path from start to goal. */
  readonly cost: number
  /** Cost of a shortest path. */
  readonly least: number
  /** What was thrown instead of an answer. */
  readonly error?: string
}

/** Somebody who claims to find shortest paths. */
interface Contender {
  readonly who: string
  readonly isOurs: boolean
  /** What a diagonal step costs; a straight one costs 1. */
  readonly diagonal: number
  readonly find: (query: Query) => ArrayLike<Cell>
}

/** Costs of paths of up to a million steps differ by more, if they are not the same. */
const TOLERANCE = 1e-6

/** Asks us, by each search, and the peers all queries of a map, and tells whose answers are wrong. */
export function faultsOn(map: BenchMap, peers: readonly Peer[]): Fault[] {
  const contenders = [...ourselves(map), ...peers.map((peer) => contenderOf(peer, map))]
  return map.queries.flatMap((query) => {
    const truth = new Map(
      [1, Math.SQRT2].map((diagonal) => [diagonal, leastCost(map.grid, query, diagonal)]),
    )
    return contenders.flatMap((contender) => {
      const least = truth.get(contender.diagonal) ?? Number.NaN
      const fault = judge(contender, map, query, least)
      return fault ? [fault] : []
    })
  })
}

/** The library, and what it is without tapes: both have run the same before they are timed. */
function ourselves({ grid }: BenchMap): Contender[] {
  return [...ours(grid, ask, ''), ...ours(grid, askTapeless, ', built without tapes')]
}

function ours(grid: Grid, asked: typeof ask, built: string): Contender[] {
  const contender = (planner: string, search: string, cost: 'cells' | 'euclidean'): Contender => ({
    who: `${planner} ${search}, cost ${cost}${built}`,
    isOurs: true,
    diagonal: cost === 'cells' ? 1 : Math.SQRT2,
    find: (query) => asked(grid, query, planner, { cost, search }).path,
  })
  // Jump points are for cost euclidean, and the visibility graph is optimal with cost cells only.
  const byCells = (planner: string) =>
    searchesOf(planner)
      .filter((search) => search !== 'jump-point')
      .map((search) => contender(planner, search, 'cells'))
  return [
    ...searchesOf('decomposition').map((search) => contender('decomposition', search, 'euclidean')),
    ...byCells('decomposition'),
    ...byCells('visibility-graph'),
  ]
}

function contenderOf({ name, on }: Peer, { grid }: BenchMap): Contender {
  const find = on(grid)
  return {
    who: name,
    isOurs: false,
    diagonal: Math.SQRT2,
    find: ({ start, goal }) => find(start, goal),
  }
}

function judge(contender: Contender, map: BenchMap, query: Query, least: number): Fault | null {
  const { who, isOurs, diagonal, find } = contender
  const fault = { who, isOurs, map, query, least }
  try {
    const cost = costOfPath(map.grid, query, find(query), diagonal)
    return Math.abs(cost - least) < TOLERANCE ? null : { ...fault, cost }
  } catch (error) {
    return { ...fault, cost: Number.NaN, error: String(error) }
  }
}
