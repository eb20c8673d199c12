import { InputError } from './errors'
import { type Cell, cellName, type Grid, MAX_SIDE, MIN_SIDE } from './grid'
import { int32View } from './int32-view'
import { isKnown } from './legal-steps'
import { plural } from './plural'
import { DIAGONAL_RULES, type DiagonalRule } from './steps'

/** What every planner is asked: the way from start to goal on a map, under one rule. A value. */
export interface Problem {
  readonly grid: Grid
  readonly start: Cell
  readonly goal: Cell
  readonly diagonal: DiagonalRule
}

/** What a side of a map must be, for messages. */
export const SIDE_IN_WORDS = `a whole number from ${MIN_SIDE} to ${MAX_SIDE}`

/** @throws InputError if a side is not a whole number from 2 to 2048. */
export function checkSize(width: number, height: number): void {
  for (const [side, size] of [
    ['width', width],
    ['height', height],
  ] as const) {
    if (!Number.isInteger(size) || size < MIN_SIDE || size > MAX_SIDE) {
      throw new InputError(`The map's ${side} is ${size}: it must be ${SIDE_IN_WORDS}.`)
    }
  }
}

function checkEnd(grid: Grid, name: 'start' | 'goal', cell: Cell): void {
  if (!Number.isInteger(cell) || cell < 0 || cell >= grid.walls.length) {
    throw new InputError(
      `The ${name} is cell ${cell}, which is not on the ${grid.width} × ${grid.height} map.`,
    )
  }
  if (grid.walls[cell]) {
    throw new InputError(`The ${name} ${cellName(grid.width, cell)} is an obstacle.`)
  }
}

function checkWalls({ width, walls }: Grid): void {
  // It is quicker to find that these walls were checked before.
  if (isKnown(walls) || (bitsOf(walls) & 0xfefefefe) === 0) return
  const cell = walls.findIndex((wall) => wall > 1)
  throw new InputError(
    `The cell ${cellName(width, cell)} is ${walls[cell]}: it must be 0, free, or 1, an obstacle.`,
  )
}

/** All bits that any of the cells has, four cells in a word. */
function bitsOf(walls: Uint8Array): number {
  const words = int32View(walls)
  let bits = 0
  let i = 0
  for (; i + 3 < words.length; i += 4) bits |= words[i] | words[i + 1] | words[i + 2] | words[i + 3]
  for (; i < words.length; i++) bits |= words[i]
  for (let cell = 4 * i; cell < walls.length; cell++) bits |= walls[cell]
  return bits
}

/** @throws InputError that says what is wrong with the map, the rule, the start or the goal. */
export function checkProblem(problem: Problem): void {
  if (!(problem?.grid?.walls instanceof Uint8Array)) {
    throw new InputError('The problem has no map: its "grid" must have "walls", a Uint8Array.')
  }
  const { grid, start, goal, diagonal } = problem
  checkSize(grid.width, grid.height)
  if (grid.walls.length !== grid.width * grid.height) {
    throw new InputError(
      `The map has ${grid.walls.length} ${plural(grid.walls.length, 'cell')}, but ${grid.width} × ${grid.height} make ${grid.width * grid.height}.`,
    )
  }
  checkWalls(grid)
  if (!DIAGONAL_RULES.includes(diagonal)) {
    throw new InputError(
      `The diagonal rule "${diagonal}" is unknown: use ${DIAGONAL_RULES.join(' or ')}.`,
    )
  }
  checkEnd(grid, 'start', start)
  checkEnd(grid, 'goal', goal)
}
