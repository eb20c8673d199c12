import { stepDirection } from './directions'
import type { Cell } from './grid'
import type { Problem } from './problem'
import { LEGAL_STEPS } from './steps'

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
  // Columns are counted on: a division for each cell would take longer than all else. What is known
  // of a step holds for the next one that adds as much, unless it would lead over the map's edge, as
  // what is known before the first one would.
  let from = path.length > 0 ? path[0] : 0
  let x = from % width
  let step = 0
  let dx = width
  let dy = 0
  for (let i = 1; i < path.length; i++) {
    const to = path[i]
    if (to - from !== step || (x + dx) >>> 0 >= width) {
      step = to - from
      dy = rowsCrossed(x + step, width)
      dx = step - Math.imul(dy, width)
      // Over the edge, it would go on at the other side of the map two rows away.
      if (!(dx >= -1 && dx <= 1) || step === 0 || (x + dx) >>> 0 >= width) return i
    }
    x += dx
    if (to < 0 || to >= walls.length || walls[to] !== 0) return i
    if (dx !== 0 && dy !== 0) {
      const direction = stepDirection(dx, dy)
      const beside = (walls[from + dx] << (4 - 2 * dx)) | (walls[to - dx] << (2 + 2 * dy))
      if (((legal[beside] >> direction) & 1) === 0) return i
    }
    from = to
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
  let from = path.length > 0 ? path[0] : 0
  let x = from % width
  let step = 0
  let dx = 0
  let isDiagonal = 0
  let diagonals = 0
  let turns = 0
  for (let i = 1; i <= steps; i++) {
    const to = path[i]
    if (to - from !== step || (x + dx) >>> 0 >= width) {
      step = to - from
      const dy = rowsCrossed(x + step, width)
      dx = step - Math.imul(dy, width)
      isDiagonal = dx & dy & 1
      turns++
    }
    diagonals += isDiagonal
    x += dx
    from = to
  }
  const length = steps - diagonals + diagonals * Math.SQRT2
  return { cells: path.length, length, turns: Math.max(0, turns - 1) }
}
