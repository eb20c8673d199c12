import { type Direction, DX, isDiagonal, stepDirection, stepOffsets } from './directions'
import type { Cell } from './grid'
import type { Problem } from './problem'
import { LEGAL_STEPS } from './steps'

/**
 * The direction of a step that adds `step` to the index of a cell in column `x`; -1 if it is none.
 * The column is given, because callers know it from the step before: dividing the index by the width
 * for each cell of a path would take longer than all the rest.
 */
function directionFrom(x: number, step: number, width: number): Direction {
  const column = x + step
  const dy = column < 0 ? -1 : column >= width ? 1 : 0
  const dx = step - dy * width
  return dx >= -1 && dx <= 1 ? stepDirection(dx, dy) : -1
}

/** The place in `path` of the first step that the problem's rule refuses; -1 if all are legal. */
export function firstIllegalStep({ grid, diagonal }: Problem, path: ArrayLike<Cell>): number {
  const { width, walls } = grid
  const offsets = stepOffsets(width)
  const legal = LEGAL_STEPS[diagonal]
  let x = path.length > 0 ? path[0] % width : 0
  for (let i = 1; i < path.length; i++) {
    const from = path[i - 1]
    const to = path[i]
    const direction = directionFrom(x, to - from, width)
    if (direction < 0 || to < 0 || to >= walls.length) return i
    let obstacles = walls[to] << direction
    if (isDiagonal(direction)) {
      const after = (direction + 1) & 7
      obstacles |= walls[from + offsets[direction - 1]] << (direction - 1)
      obstacles |= walls[from + offsets[after]] << after
    }
    if (((legal[obstacles] >> direction) & 1) === 0) return i
    x += DX[direction]
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

/** Measures a path whose cells are neighbours, each of the one before. */
export function measurePath(width: number, path: ArrayLike<Cell>): PathMeasure {
  const steps = Math.max(0, path.length - 1)
  let x = path.length > 0 ? path[0] % width : 0
  let diagonals = 0
  let turns = 0
  let before = -1
  for (let i = 0; i < steps; i++) {
    const direction = directionFrom(x, path[i + 1] - path[i], width)
    diagonals += direction & 1
    if (direction !== before && i > 0) turns++
    before = direction
    x += DX[direction]
  }
  return { cells: path.length, length: steps - diagonals + diagonals * Math.SQRT2, turns }
}
