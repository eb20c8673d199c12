import type { Cell, Grid } from '../../src/grid/grid'
import type { BenchMap, Query } from './maps'
import { ask, askTapeless, searchesOf } from './ours'
import { onAnyMap, type Peer } from './peers/peer'
import { leastCost } from './plain/dijkstra'
import { costOfPath } from './plain/steps'
import { type Question, questionsOn } from './questions'

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
  readonly find: (grid: Grid, query: Query) => ArrayLike<Cell>
}

/** Costs of paths of up to a million steps differ by more, if they are not the same. */
const TOLERANCE = 1e-6

/**
 * Asks us, by each search, and the peers all queries of maps, each of them in turn as when they are
 * timed, and tells whose answers are wrong.
 */
export function faultsOn(maps: readonly BenchMap[], peers: readonly Peer[]): Fault[] {
  const asked = questionsOn(maps).map((question) => ({ question, least: leastCosts(question) }))
  return [...ourselves(), ...peers.map(contenderOf)].flatMap((contender) =>
    asked.flatMap(({ question, least }) => {
      const fault = judge(contender, question, least.get(contender.diagonal) ?? Number.NaN)
      return fault ? [fault] : []
    }),
  )
}

/** By what a diagonal step costs. */
function leastCosts({ map, query }: Question): ReadonlyMap<number, number> {
  return new Map(
    [1, Math.SQRT2].map((diagonal) => [diagonal, leastCost(map.grid, query, diagonal)]),
  )
}

/** The library, and what it is without tapes: both have run the same before they are timed. */
function ourselves(): Contender[] {
  return [...ours(ask, ''), ...ours(askTapeless, ', built without tapes')]
}

function ours(asked: typeof ask, built: string): Contender[] {
  const contender = (planner: string, search: string, cost: 'cells' | 'euclidean'): Contender => ({
    who: `${planner} ${search}, cost ${cost}${built}`,
    isOurs: true,
    diagonal: cost === 'cells' ? 1 : Math.SQRT2,
    find: (grid, query) => asked(grid, query, planner, { cost, search }).path,
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

function contenderOf(peer: Peer): Contender {
  return { who: peer.name, isOurs: false, diagonal: Math.SQRT2, find: onAnyMap(peer) }
}

function judge(contender: Contender, { map, query }: Question, least: number): Fault | null {
  const { who, isOurs, diagonal, find } = contender
  const fault = { who, isOurs, map, query, least }
  try {
    const cost = costOfPath(map.grid, query, find(map.grid, query), diagonal)
    return Math.abs(cost - least) < TOLERANCE ? null : { ...fault, cost }
  } catch (error) {
    return { ...fault, cost: Number.NaN, error: String(error) }
  }
}
