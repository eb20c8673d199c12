import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask, searchesOf } from '../ours'
import { easystar } from '../peers/easystar'
import { ngraphAStar, ngraphAStarBuilt } from '../peers/ngraph'
import { pathfindingAStar, pathfindingDijkstra, pathfindingJumpPoint } from '../peers/pathfinding'
import { onAnyMap, type Peer } from '../peers/peer'
import { allQueries } from '../questions'

/** Larger maps are too much for graphs of objects and for hashes of cells. */
const MOST_CELLS = 200 * 200
/** Building a graph for each query takes so long that small maps must do. */
const MOST_CELLS_BUILT = 60 * 40

/** How many times as fast as its peer each search must be; where nothing is said it is only shown. */
export interface SearchTargets {
  readonly dijkstra?: number
  readonly 'a-star'?: number
  readonly 'jump-point'?: number
}

/** A search, the peer that does the same, and how many times as fast ours must be. */
type Duel = readonly [search: string, peer: Peer, atLeast?: number | undefined]

/** Grid decomposition by each search, against the peers that do the same: all queries of a map. */
export function searchCases(map: BenchMap, targets: SearchTargets): Case[] {
  const cells = map.grid.walls.length
  const others = [
    ...(cells <= MOST_CELLS_BUILT ? [ngraphAStarBuilt] : []),
    ...(cells <= MOST_CELLS ? [ngraphAStar, easystar] : []),
  ]
  return casesOf([map], 'decomposition', [
    ['dijkstra', pathfindingDijkstra, targets.dijkstra],
    ['a-star', pathfindingAStar, targets['a-star']],
    ...others.map((peer): Duel => ['a-star', peer]),
    ['jump-point', pathfindingJumpPoint, targets['jump-point']],
  ])
}

/**
 * The same on maps in turn, so that each query is the first one on its map. Dijkstra's algorithm on
 * large maps is left out: its peer takes seconds, and legal steps are all that ours keeps.
 */
export function firstQueryCases(maps: readonly BenchMap[]): Case[] {
  const isSmall = maps[0].grid.walls.length <= MOST_CELLS
  return casesOf(maps, 'first query on a map, decomposition', [
    ...(isSmall ? [['dijkstra', pathfindingDijkstra] as const] : []),
    ['a-star', pathfindingAStar],
    ['jump-point', pathfindingJumpPoint],
  ])
}

/**
 * What is around a search by jump points, against the peer's whole queries: ours is asked for the way
 * to the cell after the start. The ratio is what there would be if searches took no time.
 */
export function ceilingCase(map: BenchMap): Case {
  const search = 'jump-point'
  const queries = map.queries.map((query) => {
    const { path } = ask(map.grid, query, 'decomposition', paramsOf(search))
    return { start: query.start, goal: path[1] }
  })
  const duel = [search, pathfindingJumpPoint] as const
  return caseOf([map], 'nothing to search, decomposition', duel, [{ ...map, queries }])
}

function casesOf(maps: readonly BenchMap[], what: string, duels: readonly Duel[]): Case[] {
  const known = searchesOf('decomposition')
  return duels.filter(([search]) => known.includes(search)).map((duel) => caseOf(maps, what, duel))
}

const paramsOf = (search: string) => ({ cost: 'euclidean', search })

/** @param oursOn the maps with what ours is asked, if that is not what the peer is asked */
function caseOf(
  maps: readonly BenchMap[],
  what: string,
  [search, peer, atLeast]: Duel,
  oursOn = maps,
): Case {
  const params = paramsOf(search)
  return {
    name: `${what} ${search}, ${maps[0].name}`,
    against: peer.name,
    ours: allQueries(oursOn, (grid, query) => ask(grid, query, 'decomposition', params)),
    peer: allQueries(maps, onAnyMap(peer)),
    unit: 'query',
    target: atLeast === undefined ? null : { atLeast },
  }
}
