import { directionOf, isDiagonal } from './directions'
import type { Cell } from './grid'
import type { Problem } from './problem'
import { legalSteps, obstaclesAround } from './steps'

/** The direction of the step between two cells of a path; only for cells next to each other. */
function stepBetween(width: number, from: Cell, to: Cell): number {
  return directionOf(
    (to % width) - (from % width),
    Math.floor(to / width) - Math.floor(from / width),
  )
}

function areNeighbours(width: number, a: Cell, b: Cell): boolean {
  const dx = Math.abs((a % width) - (b % width))
  const dy = Math.abs(Math.floor(a / width) - Math.floor(b / width))
  return Math.max(dx, dy) === 1
}

/** The place in `path` of the first step that the problem's rule refuses; -1 if all are legal. */
export function firstIllegalStep(problem: Problem, path: ArrayLike<Cell>): number {
  const { grid, diagonal } = problem
  for (let i = 1; i < path.length; i++) {
    if (!areNeighbours(grid.width, path[i - 1], path[i])) return i
    const legal = legalSteps(diagonal, obstaclesAround(grid, path[i - 1]))
    if (((legal >> stepBetween(grid.width, path[i - 1], path[i])) & 1) === 0) return i
  }
  return -1
}

export interface PathMeasure {
  /** Cells on the path, start and goal included. */
  readonly cells: number
  /** Length in cell sides: 1 for a straight step, √2 for a diagonal one (octile). */
  readonly length: number
  /** How often the direction of travel changes. */
  readonly turns: number
}

export function measurePath(width: number, path: ArrayLike<Cell>): PathMeasure {
  let diagonals = 0
  let turns = 0
  let before = -1
  for (let i = 1; i < path.length; i++) {
    const direction = stepBetween(width, path[i - 1], path[i])
    if (isDiagonal(direction)) diagonals++
    if (before >= 0 && direction !== before) turns++
    before = direction
  }
  const steps = Math.max(0, path.length - 1)
  return { cells: path.length, length: steps - diagonals + diagonals * Math.SQRT2, turns }
}
