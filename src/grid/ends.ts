import { InputError } from './errors'
import type { Cell, Grid } from './grid'

/**
 * A start on the left and a goal on the right for a map that comes without: the free cells nearest
 * to the middle of each side, two different ones unless there is only one.
 * @throws InputError if no cell is free.
 */
export function defaultEnds(grid: Grid): { start: Cell; goal: Cell } {
  const middle = Math.floor((grid.height - 1) / 2)
  const start = nearestFreeCell(grid, 0, middle)
  if (start < 0) throw new InputError('The map has no free cell.')
  const goal = nearestFreeCell(grid, grid.width - 1, middle, start)
  return { start, goal: goal < 0 ? start : goal }
}

/** The free cell other than `except` with the least Euclidean distance to (x, y); -1 if none. */
export function nearestFreeCell(
  { width, walls }: Grid,
  x: number,
  y: number,
  except: Cell = -1,
): Cell {
  let nearest = -1
  let least = Number.POSITIVE_INFINITY
  for (let cell = 0; cell < walls.length; cell++) {
    if (walls[cell] || cell === except) continue
    const column = cell % width
    const dx = column - x
    const dy = (cell - column) / width - y
    const square = dx * dx + dy * dy
    if (square >= least) continue
    nearest = cell
    least = square
  }
  return nearest
}
