import * as v from 'valibot'
import { InputError } from '../errors'
import { type Cell, type Grid, isInside } from '../grid'
import { checkProblem, type Problem } from '../problem'
import { DIAGONAL_RULES } from '../steps'
import { gridFromRows, rowByRow } from '../text-map'
import type { OpenedMap } from './opened-map'
import { list, readShape, whole } from './shape'

/** The name and the version that the files of this project carry. */
export const FORMAT = 'path-planner'
const VERSION = 1

/** A problem as a JSON text, one line a row of the map, in parts; `openMap` reads it. */
export function* saveProject(problem: Problem): Generator<string, void, void> {
  const { grid, start, goal, diagonal } = problem
  const point = (cell: Cell) => `[${cell % grid.width}, ${Math.floor(cell / grid.width)}]`
  yield `{
  "format": "${FORMAT}",
  "version": ${VERSION},
  "diagonal": "${diagonal}",
  "start": ${point(start)},
  "goal": ${point(goal)},
  "rows": [`
  let between = ''
  for (const row of rowByRow(grid)) {
    yield `${between}\n    "${row}"`
    between = ','
  }
  yield '\n  ]\n}\n'
}

const versionShape = v.object({ version: whole })
const pointShape = v.strictTuple([whole, whole])
const shape = v.object({
  diagonal: v.picklist(DIAGONAL_RULES),
  start: pointShape,
  goal: pointShape,
  rows: list,
})

const words = {
  version: 'a whole number',
  diagonal: DIAGONAL_RULES.map((rule) => `"${rule}"`).join(' or '),
  start: 'two whole numbers, [x, y]',
  goal: 'two whole numbers, [x, y]',
  rows: 'a list of texts, one a row of the map',
}

/**
 * The problem in the JSON value of a file that `saveProject` wrote.
 * @throws InputError that says which key, row or cell is wrong.
 */
export function readProject(value: unknown): OpenedMap {
  const { version } = readShape(versionShape, words, value)
  if (version !== VERSION) {
    throw new InputError(
      `This file is of version ${version}; this program reads version ${VERSION}.`,
    )
  }
  const { diagonal, start, goal, rows } = readShape(shape, words, value)
  const grid = gridFromRows(rows)
  const problem: Problem = {
    grid,
    start: cellAt(grid, 'start', start),
    goal: cellAt(grid, 'goal', goal),
    diagonal,
  }
  checkProblem(problem)
  return { problem, notes: [] }
}

function cellAt(grid: Grid, name: string, [x, y]: readonly [number, number]): Cell {
  if (isInside(grid, x, y)) return y * grid.width + x
  throw new InputError(`The ${name} (${x}, ${y}) is not on the ${grid.width} × ${grid.height} map.`)
}
