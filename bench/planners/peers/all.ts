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

/** Those that can take a map of a million cells, and are timed there. */
export const sturdyPeers: readonly Peer[] = [
  pathfindingDijkstra,
  pathfindingAStar,
  pathfindingJumpPoint,
]

export const allPeers: readonly Peer[] = [
  ...sturdyPeers,
  pathfindingJumpPointDefault,
  pathfindingBiAStar,
  ngraphAStar,
  ngraphNba,
  easystar,
]
