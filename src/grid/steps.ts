import { DX, DY } from './directions'
import { type Cell, type Grid, isObstacle } from './grid'

/**
 * When a diagonal step is legal: unless both cells beside it are obstacles (the report's rule), or
 * only if both are free (no corner cutting, the MovingAI benchmark's).
 */
export type DiagonalRule = 'if-at-most-one-obstacle' | 'only-when-no-obstacles'

export const DIAGONAL_RULES: readonly DiagonalRule[] = [
  'if-at-most-one-obstacle',
  'only-when-no-obstacles',
]

/** A set of directions, one bit each (`1 << direction`). */
export type Directions = number

/** The directions d for which d - 1 is in the set. */
const turned = (set: Directions): Directions => ((set << 1) | (set >> 7)) & 255
const turnedBack = (set: Directions): Directions => ((set >> 1) | (set << 7)) & 255

const DIAGONALS: Directions = 0b10101010

function legalTable(rule: DiagonalRule): Uint8Array {
  return Uint8Array.from({ length: 256 }, (_, obstacles) => {
    const [before, after] = [turned(obstacles), turnedBack(obstacles)]
    const barred = rule === 'if-at-most-one-obstacle' ? before & after : before | after
    return ~(obstacles | (barred & DIAGONALS)) & 255
  })
}

/** By rule and by the directions of obstacles around a free cell: the legal steps from it. */
export const LEGAL_STEPS: Record<DiagonalRule, Uint8Array> = {
  'if-at-most-one-obstacle': legalTable('if-at-most-one-obstacle'),
  'only-when-no-obstacles': legalTable('only-when-no-obstacles'),
}

/**
 * The legal steps from a free cell whose neighbours in the directions `obstacles` are obstacles.
 * The one definition of a legal step: the map's and the rover's both ask here.
 */
export function legalSteps(rule: DiagonalRule, obstacles: Directions): Directions {
  return LEGAL_STEPS[rule][obstacles]
}

/** The directions in which the neighbour of a cell is an obstacle. */
export function obstaclesAround(grid: Grid, cell: Cell): Directions {
  const { width, walls } = grid
  const x = cell % width
  if (x === 0 || x === width - 1 || cell < width || cell >= walls.length - width) {
    const y = Math.floor(cell / width)
    let obstacles = 0
    for (let d = 0; d < 8; d++) if (isObstacle(grid, x + DX[d], y + DY[d])) obstacles |= 1 << d
    return obstacles
  }
  // Away from the border no neighbour has to be asked whether it is on the map.
  const above = cell - width
  const below = cell + width
  return (
    walls[above] |
    (walls[above + 1] << 1) |
    (walls[cell + 1] << 2) |
    (walls[below + 1] << 3) |
    (walls[below] << 4) |
    (walls[below - 1] << 5) |
    (walls[cell - 1] << 6) |
    (walls[above - 1] << 7)
  )
}
