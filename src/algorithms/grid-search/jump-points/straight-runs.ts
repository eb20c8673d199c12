import { type Direction, DX, DY } from '../../../grid/directions'
import type { Grid } from '../../../grid/grid'
import type { DiagonalRule } from '../../../grid/steps'
import { type BitLines, reversed, rowLines, transposed } from './bit-lines'

const NORTH: Direction = 0
const EAST: Direction = 2
const SOUTH: Direction = 4
const WEST: Direction = 6

/**
 * How far steps in one straight direction lead before there is a choice, or no way on. Read from bits,
 * 32 cells at once. (D. Harabor and A. Grastien, "Improving jump point search", 2014.)
 */
export interface StraightRuns {
  /**
   * Line by line two words for 32 places, which are counted the way that the steps go: where the way
   * does not just lead onward, and where it leads somewhere else.
   */
  readonly marks: Int32Array
  /** Words of a line: a row, or a column for steps to north or south. */
  readonly wordsEach: number
  /** The place of the cell in column or row 0. */
  readonly first: number
}

/** By direction; there is nothing for diagonal ones. */
export function straightRuns({ walls, width }: Grid, rule: DiagonalRule): readonly StraightRuns[] {
  const rows = rowLines(walls, width)
  const columns = transposed(rows, width)
  const runs: StraightRuns[] = []
  runs[EAST] = { ...marked(rows, rule), first: 0 }
  runs[WEST] = { ...marked(reversed(rows), rule), first: 32 * rows.wordsEach - 1 }
  runs[SOUTH] = { ...marked(columns, rule), first: 0 }
  runs[NORTH] = { ...marked(reversed(columns), rule), first: 32 * columns.wordsEach - 1 }
  return runs
}

/** The run from (x, y) in straight direction `d`, of whose `runs` these are. */
export function runFrom(
  { marks, wordsEach, first }: StraightRuns,
  x: number,
  y: number,
  d: Direction,
): number {
  return DX[d] === 0
    ? runAlong(marks, x * wordsEach, first + y * DY[d] + 1)
    : runAlong(marks, y * wordsEach, first + x * DX[d] + 1)
}

/**
 * Steps from the place before `place` to the first one with another way than onward; if the way ends
 * before, the steps to where it would end in an obstacle, negative.
 * @param line where the line begins among the marks
 */
export function runAlong(marks: Int32Array, line: number, place: number): number {
  let i = line + ((place >> 5) << 1)
  let word = marks[i] & (-1 << place)
  let first = place & ~31
  while (word === 0) {
    i += 2
    first += 32
    word = marks[i]
  }
  const bit = 31 - Math.clz32(word & -word)
  const steps = first + bit + 1 - place
  return (marks[i + 1] >>> bit) & 1 ? steps : -steps
}

function marked(obstacles: BitLines, rule: DiagonalRule): Omit<StraightRuns, 'first'> {
  const { words, lines, wordsEach } = obstacles
  const turns = rule === 'only-when-no-obstacles' ? turnsBehindCorners : turnsAroundCorners
  const marks = new Int32Array(2 * words.length)
  for (let line = 0, at = 0; line < lines; line++) {
    for (let i = 0; i < wordsEach; i++, at++) {
      let turn = 0
      if (line > 0) turn |= turns(obstacles, at, i, at - wordsEach)
      if (line < lines - 1) turn |= turns(obstacles, at, i, at + wordsEach)
      turn &= ~words[at]
      marks[2 * at] = words[at] | ahead(obstacles, at, i) | turn
      marks[2 * at + 1] = turn
    }
  }
  return { marks, wordsEach: 2 * wordsEach }
}

/** Where corners block: a side that is free, where it was not yet at the cell before. */
function turnsBehindCorners(obstacles: BitLines, _: number, i: number, beside: number): number {
  return ~obstacles.words[beside] & behind(obstacles, beside, i)
}

/** Where they do not: a side that is not free, and is one cell on, where the way leads on, too. */
function turnsAroundCorners(obstacles: BitLines, at: number, i: number, beside: number): number {
  return obstacles.words[beside] & ~ahead(obstacles, beside, i) & ~ahead(obstacles, at, i)
}

/** For each place of a word, the one that is number `i` of its line, what is at the next place. */
function ahead({ words, wordsEach }: BitLines, at: number, i: number): number {
  const next = i < wordsEach - 1 ? words[at + 1] : -1
  return (words[at] >>> 1) | (next << 31)
}

/** And what is at the place before. */
function behind({ words }: BitLines, at: number, i: number): number {
  const before = i > 0 ? words[at - 1] : -1
  return (words[at] << 1) | (before >>> 31)
}
