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
  { width, height, walls }: Grid,
  x: number,
  y: number,
  except: Cell = -1,
): Cell {
  let nearest = -1
  let least = Number.POSITIVE_INFINITY
  for (let row = 0; row < height; row++) {
    const down = (row - y) ** 2
    if (down >= least) continue
    for (let column = 0, cell = row * width; column < width; column++, cell++) {
      if (walls[cell] || cell === except) continue
      const square = (column - x) * (column - x) + down
      if (square >= least) continue
      nearest = cell
      least = square
    }
  }
  return nearest
}
