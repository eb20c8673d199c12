import { isDiagonal, stepDirection, stepOffsets } from './directions'
import type { Cell } from './grid'
import type { Problem } from './problem'
import { LEGAL_STEPS } from './steps'

/** The direction of each step of a path; -1 where two cells that follow are not neighbours. */
export function stepDirections(width: number, path: ArrayLike<Cell>): Int8Array {
  const directions = new Int8Array(Math.max(0, path.length - 1))
  let x = path.length > 0 ? path[0] % width : 0
  for (let i = 0; i < directions.length; i++) {
    const step = path[i + 1] - path[i]
    // Columns are counted on from cell to cell: a division for each takes longer than all else.
    const column = x + step
    const dy = column < 0 ? -1 : column >= width ? 1 : 0
    const dx = step - dy * width
    directions[i] = dx >= -1 && dx <= 1 ? stepDirection(dx, dy) : -1
    x = column - dy * width
  }
  return directions
}

/**
 * The place in `path` of the first step that the problem's rule refuses; -1 if all are legal.
 * @param directions those of its steps, if they are known
 */
export function firstIllegalStep(
  { grid, diagonal }: Problem,
  path: ArrayLike<Cell>,
  directions = stepDirections(grid.width, path),
): number {
  const { width, walls } = grid
  const offsets = stepOffsets(width)
  const legal = LEGAL_STEPS[diagonal]
  for (let i = 0; i < directions.length; i++) {
    const direction = directions[i]
    const from = path[i]
    const to = path[i + 1]
    if (direction < 0 || to < 0 || to >= walls.length) return i + 1
    let obstacles = walls[to] << direction
    if (isDiagonal(direction)) {
      const after = (direction + 1) & 7
      obstacles |= walls[from + offsets[direction - 1]] << (direction - 1)
      obstacles |= walls[from + offsets[after]] << after
    }
    if (((legal[obstacles] >> direction) & 1) === 0) return i + 1
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

/** @param directions those of its steps, if they are known */
export function measurePath(
  width: number,
  path: ArrayLike<Cell>,
  directions = stepDirections(width, path),
): PathMeasure {
  let diagonals = 0
  let turns = 0
  for (let i = 0; i < directions.length; i++) {
    if (isDiagonal(directions[i])) diagonals++
    if (i > 0 && directions[i] !== directions[i - 1]) turns++
  }
  const straights = directions.length - diagonals
  return { cells: path.length, length: straights + diagonals * Math.SQRT2, turns }
}
