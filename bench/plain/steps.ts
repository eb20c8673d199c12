import type { Cell, Grid } from '../../src/grid/grid'
import type { Query } from '../maps'

/**
 * The rule `only-when-no-obstacles` once more, cell by cell and without a look at the library's own
 * idea of it: what decides who is wrong must not share code with those it judges.
 */
export function isLegalStep({ width, height, walls }: Grid, from: Cell, to: Cell): boolean {
  const x = from % width
  const y = (from - x) / width
  const nextX = to % width
  const nextY = (to - nextX) / width
  if (nextX < 0 || nextY < 0 || nextY >= height || walls[to]) return false
  const dx = Math.abs(nextX - x)
  const dy = Math.abs(nextY - y)
  if (dx > 1 || dy > 1 || dx + dy === 0) return false
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
  let diagonals = 0
  for (let i = 1; i < path.length; i++) {
    if (!isLegalStep(grid, path[i - 1], path[i])) return Number.NaN
    const apart = Math.abs(path[i] - path[i - 1])
    if (apart !== 1 && apart !== grid.width) diagonals++
  }
  return path.length - 1 - diagonals + diagonals * diagonal
}
