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
 * Its grids serve one query each, so each query is charged with one. To make it of the walls takes
 * about half as long as to copy one that was kept: a copy has all its nodes made twice.
 */
function peer(name: string, finder: PF.Finder): Peer {
  const on = (grid: Grid) => (start: number, goal: number) => {
    const { width } = grid
    const [x, y] = [start % width, goal % width]
    const own = gridOf(grid)
    const path = finder.findPath(x, (start - x) / width, y, (goal - y) / width, own)
    return path.map(([column, row]) => row * width + column)
  }
  return { name: `pathfinding ${name}`, on }
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
