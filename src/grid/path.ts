import { stepDirection } from './directions'
import type { Cell } from './grid'
import type { Problem } from './problem'
import { LEGAL_STEPS } from './steps'

// Nobody can foretell which way a path goes on, so there is no branch on that in the loops below:
// where processors guess wrong, they wait longer than for all the rest.

/**
 * By how many rows a step changes: -1, 0 or 1. `column` is the column that it begins in plus what it
 * adds to the index of its cell; where that is not on the row, the step leads into another one.
 */
const rowsCrossed = (column: number, width: number): number =>
  (column >> 31) - ((width - 1 - column) >> 31)

/** The place in `path` of the first step that the problem's rule refuses; -1 if all are legal. */
export function firstIllegalStep({ grid, diagonal }: Problem, path: ArrayLike<Cell>): number {
  const { width, walls } = grid
  const legal = LEGAL_STEPS[diagonal]
  // Columns are counted on: a division for each cell would take longer than all else.
  let x = path.length > 0 ? path[0] % width : 0
  for (let i = 1; i < path.length; i++) {
    const from = path[i - 1]
    const to = path[i]
    const dy = rowsCrossed(x + to - from, width)
    const dx = to - from - Math.imul(dy, width)
    if (!(dx >= -1 && dx <= 1) || to < 0 || to >= walls.length || to === from) return i
    // Over the edge of the map, and on at the other side of it two rows away.
    if ((x + dx) >>> 0 >= width) return i
    const direction = stepDirection(dx, dy)
    const beside = (walls[from + dx] << (4 - 2 * dx)) | (walls[to - dx] << (2 + 2 * dy))
    const obstacles = (walls[to] << direction) | (beside & -(direction & 1))
    if (((legal[obstacles] >> direction) & 1) === 0) return i
    x += dx
  }
  return -1
}

/** How long a path is, and how straight. */
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
  let dx = 0
  let dy = 0
  let diagonals = 0
  let turns = 0
  for (let i = 1; i <= steps; i++) {
    const step = path[i] - path[i - 1]
    const down = rowsCrossed(x + step, width)
    const right = step - Math.imul(down, width)
    diagonals += right & down & 1
    if (i > 1 && (right !== dx || down !== dy)) turns++
    dx = right
    dy = down
    x += right
  }
  return { cells: path.length, length: steps - diagonals + diagonals * Math.SQRT2, turns }
}
