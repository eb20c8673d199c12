import { type Grid, isObstacle, type Point } from '../grid/grid'

/**
 * Whether nothing stands between the centres of two cells: no obstacle on the straight line from
 * one to the other, ends apart. A line that passes exactly between two cells is stopped only if
 * both are obstacles, so the 8 neighbours are always in sight.
 */
export function isInSight(grid: Grid, from: Point, to: Point): boolean {
  const dx = to.x - from.x
  const dy = to.y - from.y
  const length = Math.max(Math.abs(dx), Math.abs(dy))
  for (let i = 1; i < length; i++) {
    const x = from.x + (dx * i) / length
    const y = from.y + (dy * i) / length
    const lower = isObstacle(grid, Math.ceil(x - 0.5), Math.ceil(y - 0.5))
    if (lower && isObstacle(grid, Math.floor(x + 0.5), Math.floor(y + 0.5))) return false
  }
  return true
}
