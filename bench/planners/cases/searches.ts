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
  const peer = pathfindingJumpPoint
  const params = { cost: 'euclidean', search: 'jump-point' }
  const oneStep = map.queries.map(({ start, goal }) => {
    return { start, goal: ask(map.grid, { start, goal }, 'decomposition', params).path[1] }
  })
  return {
    name: `nothing to search, decomposition jump-point, ${map.name}`,
    against: peer.name,
    ours: allQueries([{ ...map, queries: oneStep }], (grid, query) =>
      ask(grid, query, 'decomposition', params),
    ),
    peer: allQueries([map], onAnyMap(peer)),
    unit: 'query',
    target: null,
  }
}

function casesOf(maps: readonly BenchMap[], what: string, duels: readonly Duel[]): Case[] {
  const known = searchesOf('decomposition')
  return duels
    .filter(([search]) => known.includes(search))
    .map(([search, peer, atLeast]) => {
      const params = { cost: 'euclidean', search }
      return {
        name: `${what} ${search}, ${maps[0].name}`,
        against: peer.name,
        ours: allQueries(maps, (grid, query) => ask(grid, query, 'decomposition', params)),
        peer: allQueries(maps, onAnyMap(peer)),
        unit: 'query',
        target: atLeast === undefined ? null : { atLeast },
      }
    })
}
