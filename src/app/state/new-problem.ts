import { nearestFreeCell } from '../../grid/ends'
import { InputError } from '../../grid/errors'
import { type Cell, emptyGrid, resized } from '../../grid/grid'
import { checkSize, type Problem } from '../../grid/problem'
import type { DiagonalRule } from '../../grid/steps'

/** A map without obstacles, the start at its left and the goal at its right. */
export function emptyProblem(width: number, height: number, diagonal: DiagonalRule): Problem {
  checkSize(width, height)
  const middle = Math.floor((height - 1) / 2) * width
  const margin = Math.floor((width - 1) / 6)
  const [start, goal] = [middle + margin, middle + width - 1 - margin]
  return { grid: emptyGrid(width, height), start, goal, diagonal }
}

/**
 * The map cut or extended at the right and the bottom. A start or goal that is cut off, or falls on
 * an obstacle, moves to the nearest free cell.
 * @throws InputError if the size is out of bounds or no free cell is left.
 */
export function resizedProblem(problem: Problem, width: number, height: number): Problem {
  checkSize(width, height)
  const grid = resized(problem.grid, width, height)
  const moved = (cell: Cell) => {
    const x = Math.min(cell % problem.grid.width, width - 1)
    const y = Math.min(Math.floor(cell / problem.grid.width), height - 1)
    const nearest = nearestFreeCell(grid, x, y)
    if (nearest >= 0) return nearest
    throw new InputError(`On ${width} × ${height} cells of this map no cell is free.`)
  }
  return { ...problem, grid, start: moved(problem.start), goal: moved(problem.goal) }
}
