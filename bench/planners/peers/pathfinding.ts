import PF from 'pathfinding'
import type { Grid } from '../../../src/grid/grid'
import type { Peer } from './peer'

const rule = { diagonalMovement: PF.DiagonalMovement.OnlyWhenNoObstacles }
const octile = { ...rule, heuristic: PF.Heuristic.octile }

const dijkstra = new PF.DijkstraFinder(rule)
const aStar = new PF.AStarFinder(octile)
const biAStar = new PF.BiAStarFinder(octile)
const jumpPointDefault = PF.JumpPointFinder(rule)
const jumpPoint = PF.JumpPointFinder(octile)

/**
 * Its grids serve one query each. A copy of a grid kept for that purpose is cheaper than a new one
 * made of the walls, so each query is charged with a copy.
 */
function peer(name: string, finder: PF.Finder): Peer {
  const on = (grid: Grid) => {
    const { width } = grid
    const kept = keptGrid(grid)
    return (start: number, goal: number) => {
      const copy = kept.clone()
      const [x, y] = [start % width, goal % width]
      const path = finder.findPath(x, (start - x) / width, y, (goal - y) / width, copy)
      return path.map(([column, row]) => row * width + column)
    }
  }
  return { name: `pathfinding ${name}`, on }
}

/** One for all finders, because those of large maps take up hundreds of megabytes. */
const keptGrids = new WeakMap<Grid, PF.Grid>()

function keptGrid(grid: Grid): PF.Grid {
  const kept = keptGrids.get(grid) ?? gridOf(grid)
  keptGrids.set(grid, kept)
  return kept
}

function gridOf({ width, height, walls }: Grid): PF.Grid {
  const grid = new PF.Grid(width, height)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) if (walls[y * width + x]) grid.setWalkableAt(x, y, false)
  }
  return grid
}

export const pathfindingDijkstra = peer('DijkstraFinder', dijkstra)
export const pathfindingAStar = peer('AStarFinder (octile)', aStar)
export const pathfindingBiAStar = peer('BiAStarFinder (octile)', biAStar)
export const pathfindingJumpPointDefault = peer('JumpPointFinder (its default)', jumpPointDefault)
export const pathfindingJumpPoint = peer('JumpPointFinder (octile)', jumpPoint)
