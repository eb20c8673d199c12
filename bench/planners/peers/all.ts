import { easystar } from './easystar'
import { ngraphAStar, ngraphNba } from './ngraph'
import {
  pathfindingAStar,
  pathfindingBiAStar,
  pathfindingDijkstra,
  pathfindingJumpPoint,
  pathfindingJumpPointDefault,
} from './pathfinding'
import type { Peer } from './peer'

/** Those that take less than a second on a map of a million cells, or little more. */
export const swiftPeers: readonly Peer[] = [pathfindingAStar, pathfindingJumpPoint]

/** Those that can take such a map, and are timed there. */
export const sturdyPeers: readonly Peer[] = [pathfindingDijkstra, ...swiftPeers]

export const allPeers: readonly Peer[] = [
  ...sturdyPeers,
  pathfindingJumpPointDefault,
  pathfindingBiAStar,
  ngraphAStar,
  ngraphNba,
  easystar,
]
