import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask, searchesOf } from '../ours'
import { easystar } from '../peers/easystar'
import { ngraphAStar, ngraphAStarBuilt } from '../peers/ngraph'
import { pathfindingAStar, pathfindingDijkstra, pathfindingJumpPoint } from '../peers/pathfinding'
import type { Find, Peer } from '../peers/peer'

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

/** Grid decomposition by each search, against the peers that do the same: all queries of a map. */
export function searchCases(map: BenchMap, targets: SearchTargets): Case[] {
  const cells = map.grid.walls.length
  const others = [
    ...(cells <= MOST_CELLS_BUILT ? [ngraphAStarBuilt] : []),
    ...(cells <= MOST_CELLS ? [ngraphAStar, easystar] : []),
  ]
  const duels: readonly (readonly [string, Peer, (number | undefined)?])[] = [
    ['dijkstra', pathfindingDijkstra, targets.dijkstra],
    ['a-star', pathfindingAStar, targets['a-star']],
    ...others.map((peer) => ['a-star', peer] as const),
    ['jump-point', pathfindingJumpPoint, targets['jump-point']],
  ]
  const known = searchesOf('decomposition')
  return duels
    .filter(([search]) => known.includes(search))
    .map(([search, peer, atLeast]) => duel(map, search, peer, atLeast))
}

function duel(map: BenchMap, search: string, peer: Peer, atLeast: number | undefined): Case {
  const { grid, queries } = map
  const params = { cost: 'euclidean', search }
  let find: Find | undefined
  return {
    name: `decomposition ${search}, ${map.name}`,
    against: peer.name,
    ours: () => {
      for (const query of queries) ask(grid, query, 'decomposition', params)
      return queries.length
    },
    peer: () => {
      find ??= peer.on(grid)
      for (const { start, goal } of queries) find(start, goal)
      return queries.length
    },
    unit: 'query',
    target: atLeast === undefined ? null : { atLeast },
  }
}
