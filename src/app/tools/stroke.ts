import { type Cell, type Grid, isInside, type Point, withCells } from '../../grid/grid'
import type { Problem } from '../../grid/problem'

/**
 * The cells of a straight line without holes from one cell to another, both included, as far as
 * they lie on the map (Bresenham). The ends may lie outside.
 */
export function lineOfCells(grid: Grid, from: Point, to: Point): Cell[] {
  const [dx, dy] = [Math.abs(to.x - from.x), Math.abs(to.y - from.y)]
  const [stepX, stepY] = [Math.sign(to.x - from.x), Math.sign(to.y - from.y)]
  const cells: Cell[] = []
  let { x, y } = from
  let error = dx - dy
  for (;;) {
    if (isInside(grid, x, y)) cells.push(y * grid.width + x)
    if (x === to.x && y === to.y) return cells
    const doubled = 2 * error
    if (doubled > -dy) {
      error -= dy
      x += stepX
    }
    if (doubled < dx) {
      error += dx
      y += stepY
    }
  }
}

/** Those of the cells that drawing or erasing would change; start and goal are left alone. */
function cellsToPaint(problem: Problem, cells: readonly Cell[], obstacle: boolean): Cell[] {
  const { grid, start, goal } = problem
  const wall = obstacle ? 1 : 0
  return [...new Set(cells)].filter(
    (cell) => cell !== start && cell !== goal && grid.walls[cell] !== wall,
  )
}

/** The map with obstacles drawn or erased, and the cells that this changed. */
export function paint(
  problem: Problem,
  cells: readonly Cell[],
  obstacle: boolean,
): { readonly grid: Grid; readonly changed: readonly Cell[] } {
  const changed = cellsToPaint(problem, cells, obstacle)
  const grid = changed.length > 0 ? withCells(problem.grid, changed, obstacle) : problem.grid
  return { grid, changed }
}

/** What a pointer takes hold of where it is pressed. The goal lies on the start if both share a cell. */
export type Grip = 'outside' | 'start' | 'goal' | 'free' | 'obstacle'

/** @param cell -1 outside the map */
export function gripAt({ grid, start, goal }: Problem, cell: Cell): Grip {
  if (cell < 0) return 'outside'
  if (cell === goal) return 'goal'
  if (cell === start) return 'start'
  return grid.walls[cell] ? 'obstacle' : 'free'
}
