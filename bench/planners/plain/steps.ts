import type { Cell, Grid } from '../../../src/grid/grid'
import type { Query } from '../maps'

/**
 * The rule `only-when-no-obstacles` once more, in columns and rows and without a look at the
 * library's own idea of it: what decides who is wrong must not share code with those it judges.
 */
export function isLegalStep(
  { width, height, walls }: Grid,
  x: number,
  y: number,
  nextX: number,
  nextY: number,
): boolean {
  if (nextX < 0 || nextY < 0 || nextX >= width || nextY >= height) return false
  const dx = Math.abs(nextX - x)
  const dy = Math.abs(nextY - y)
  if (dx > 1 || dy > 1 || dx + dy === 0 || walls[nextY * width + nextX]) return false
  return dx + dy === 1 || (!walls[y * width + nextX] && !walls[nextY * width + x])
}

/**
 * Cost of a path, straight steps at 1 and diagonal ones at `diagonal`; NaN if it does not lead from
 * start to goal or has a step that is not legal.
 */
export function costOfPath(
  grid: Grid,
  { start, goal }: Query,
  path: ArrayLike<Cell>,
  diagonal: number,
): number {
  if (path[0] !== start || path[path.length - 1] !== goal) return Number.NaN
  const { width } = grid
  let diagonals = 0
  for (let i = 1; i < path.length; i++) {
    const [x, nextX] = [path[i - 1] % width, path[i] % width]
    const [y, nextY] = [Math.floor(path[i - 1] / width), Math.floor(path[i] / width)]
    if (!isLegalStep(grid, x, y, nextX, nextY)) return Number.NaN
    if (x !== nextX && y !== nextY) diagonals++
  }
  return path.length - 1 - diagonals + diagonals * diagonal
}
