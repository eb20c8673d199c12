import * as v from 'valibot'
import { InputError } from '../errors'
import { describe, excerpt } from '../excerpt'
import type { Cell, Grid } from '../grid'
import { checkProblem, checkSize, type Problem } from '../problem'
import { DIAGONAL_RULES } from '../steps'
import { gridToRows } from '../text-map'
import type { OpenedMap } from './opened-map'
import { list, readShape, whole } from './shape'

/** The name and the version that the files of this project carry. */
export const FORMAT = 'path-planner'
export const VERSION = 1

/** A problem as a JSON text, one line a row of the map; `openMap` reads it. */
export function saveProject({ grid, start, goal, diagonal }: Problem): string {
  const point = (cell: Cell) => `[${cell % grid.width}, ${Math.floor(cell / grid.width)}]`
  return `{
  "format": "${FORMAT}",
  "version": ${VERSION},
  "diagonal": "${diagonal}",
  "start": ${point(start)},
  "goal": ${point(goal)},
  "rows": [
    "${gridToRows(grid).join('",\n    "')}"
  ]
}
`
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

/**
 * A map from its rows, `#` obstacle and `.` free.
 * @throws InputError that names the row or the cell that is wrong.
 */
export function gridFromRows(rows: readonly unknown[]): Grid {
  const width = rows.length === 0 ? 0 : rowText(rows, 0).length
  checkSize(width, rows.length)
  const walls = new Uint8Array(width * rows.length)
  for (let y = 0; y < rows.length; y++) {
    const row = rowText(rows, y)
    if (row.length !== width) {
      throw new InputError(`Row ${y + 1} has ${row.length} cells, but row 1 has ${width}.`)
    }
    for (let x = 0; x < width; x++) {
      if (row[x] === '#') walls[y * width + x] = 1
      else if (row[x] !== '.') {
        const sign = excerpt(row.slice(x), 1)
        throw new InputError(`${sign} at (${x}, ${y}) is no cell: use "#" obstacle, "." free.`)
      }
    }
  }
  return { width, height: rows.length, walls }
}

function rowText(rows: readonly unknown[], y: number): string {
  const row = rows[y]
  if (typeof row === 'string') return row
  throw new InputError(`Row ${y + 1} must be a text of "#" and ".", but is ${describe(row)}.`)
}

function cellAt({ width, height }: Grid, name: string, [x, y]: readonly [number, number]): Cell {
  if (x >= 0 && y >= 0 && x < width && y < height) return y * width + x
  throw new InputError(`The ${name} (${x}, ${y}) is not on the ${width} × ${height} map.`)
}
