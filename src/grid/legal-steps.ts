import { stepOffsets } from './directions'
import { differences } from './edits'
import type { Cell, Grid } from './grid'
import { type DiagonalRule, type Directions, legalSteps, obstaclesAround } from './steps'

/** The latest map that was asked about. */
interface Known {
  readonly rule: DiagonalRule
  readonly width: number
  readonly walls: Uint8Array
  readonly steps: Uint8Array
}

let known: Known | null = null

/**
 * The legal steps from every cell of the map, a set of directions each; none from an obstacle. Not to
 * be written into: the same array answers the same question again. If the map differs from the one
 * before in a few cells only, as after a stroke, no more than their neighbourhoods are looked at.
 */
export function allLegalSteps(grid: Grid, rule: DiagonalRule): Uint8Array {
  const before = known
  if (before === null || !isOfSameKind(before, grid, rule))
    return learn(grid, rule, built(grid, rule))
  // Compared by content: nobody keeps a program from writing into its own map between two questions.
  const most = grid.walls.length >> 6
  const edits = differences(before.walls, grid.walls, most)
  if (edits.length === 0) return before.steps
  const isOther = edits.length > most
  return learn(grid, rule, isOther ? built(grid, rule) : patched(before.steps, edits, grid, rule))
}

/** Whether the latest map that was asked about had just these walls. */
export const isKnown = (walls: Uint8Array): boolean =>
  known !== null &&
  known.walls.length === walls.length &&
  differences(known.walls, walls, 0).length === 0

const isOfSameKind = (before: Known, { width, walls }: Grid, rule: DiagonalRule): boolean =>
  before.rule === rule && before.width === width && before.walls.length === walls.length

function learn({ width, walls }: Grid, rule: DiagonalRule, steps: Uint8Array): Uint8Array {
  // No `slice`: that of a Node Buffer, which is a Uint8Array too, makes no copy.
  known = { rule, width, walls: new Uint8Array(walls), steps }
  return steps
}

function patched(
  before: Uint8Array,
  edits: readonly Cell[],
  grid: Grid,
  rule: DiagonalRule,
): Uint8Array {
  const { width, walls } = grid
  const steps = before.slice()
  const offsets = [0, ...stepOffsets(width)]
  for (const edit of edits) {
    for (const offset of offsets) {
      const cell = edit + offset
      if (cell < 0 || cell >= walls.length) continue
      // At the ends of a row this may be a cell at the other side of the map: no harm, no gain.
      steps[cell] = walls[cell] ? 0 : legalSteps(rule, obstaclesAround(grid, cell))
    }
  }
  return steps
}

/** Slides a window of three columns along each row. */
function built({ width, height, walls }: Grid, rule: DiagonalRule): Uint8Array {
  const table = windowsUnder(rule)
  const steps = new Uint8Array(walls.length)
  const border = new Uint8Array(width).fill(1)
  const row = (y: number) =>
    y < 0 || y >= height ? border : walls.subarray(y * width, (y + 1) * width)
  for (let y = 0; y < height; y++) {
    slide(table, row(y - 1), row(y), row(y + 1), steps.subarray(y * width, (y + 1) * width))
  }
  return steps
}

const COLUMN = 0b111

function slide(
  table: Uint8Array,
  above: Uint8Array,
  here: Uint8Array,
  below: Uint8Array,
  steps: Uint8Array,
): void {
  const last = steps.length - 1
  let seen = (COLUMN << 3) | (above[0] << 2) | (here[0] << 1) | below[0]
  for (let x = 0; x < last; x++) {
    seen = ((seen << 3) & 0o777) | (above[x + 1] << 2) | (here[x + 1] << 1) | below[x + 1]
    steps[x] = table[seen]
  }
  steps[last] = table[((seen << 3) & 0o777) | COLUMN]
}

/** Where the neighbour in each direction stands in a window: columns of three, the right one lowest. */
const PLACES = Int8Array.of(5, 2, 1, 0, 3, 6, 7, 8)
const MIDDLE = 1 << 4

const tables: Partial<Record<DiagonalRule, Uint8Array>> = {}

/** By a window of nine cells the legal steps from the one in the middle. */
function windowsUnder(rule: DiagonalRule): Uint8Array {
  tables[rule] ??= Uint8Array.from({ length: 512 }, (_, window) => {
    let obstacles: Directions = 0
    for (let d = 0; d < 8; d++) obstacles |= ((window >> PLACES[d]) & 1) << d
    return window & MIDDLE ? 0 : legalSteps(rule, obstacles)
  })
  return tables[rule]
}
