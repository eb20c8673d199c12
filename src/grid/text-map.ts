import { InputError } from './errors'
import { describe, excerpt } from './excerpt'
import { fileText } from './file-text'
import type { Cell, Grid } from './grid'
import { plural } from './plural'
import { checkProblem, checkSize, type Problem } from './problem'
import type { DiagonalRule } from './steps'

/**
 * A problem from a text map, one line a row: `#` obstacle, `.` free, `S` start, `G` goal.
 * Empty lines before and after the map and blanks around its lines do not count.
 * @throws InputError that names the line and the column of what is wrong.
 */
export function problemFromText(
  text: string,
  diagonal: DiagonalRule = 'if-at-most-one-obstacle',
): Problem {
  const rows = fileText(text)
    .trim()
    .split(/\r?\n/)
    .map((row) => row.trim())
  const width = rows[0].length
  checkSize(width, rows.length)
  const walls = new Uint8Array(width * rows.length)
  const ends = new Map<string, Cell>()
  rows.forEach((row, y) => {
    if (row.length !== width) {
      throw unequalRows(y, row.length, width)
    }
    for (let x = 0; x < width; x++) {
      const sign = row[x]
      const cell = y * width + x
      if (sign === '#') walls[cell] = 1
      else if (sign === 'S' || sign === 'G') {
        if (ends.has(sign)) throw new InputError(`A second "${sign}" at (${x}, ${y}).`)
        ends.set(sign, cell)
      } else if (sign !== '.') {
        throw new InputError(
          `${excerpt(row.slice(x), 1)} at (${x}, ${y}) is no cell: use "#" obstacle, "." free, "S" start, "G" goal.`,
        )
      }
    }
  })
  const start = ends.get('S')
  const goal = ends.get('G')
  if (start === undefined) throw new InputError('The map has no start ("S").')
  if (goal === undefined) throw new InputError('The map has no goal ("G").')
  const problem = { grid: { width, height: rows.length, walls }, start, goal, diagonal }
  checkProblem(problem)
  return problem
}

const SIGN = { free: 0x2e, obstacle: 0x23, start: 0x53, goal: 0x47 } as const

/** Written out, as a callback for each of millions of cells takes several times as long. */
function signs({ walls }: Grid, obstacle: number): Uint8Array {
  const signs = new Uint8Array(walls.length)
  for (let cell = 0; cell < walls.length; cell++) signs[cell] = walls[cell] ? obstacle : SIGN.free
  return signs
}

/** The list of signs is handed on as it is, because to spread it takes several times as long. */
function* rowsOf(signs: Uint8Array, { width }: Grid): Generator<string, void, void> {
  for (let at = 0; at < signs.length; at += width) {
    yield Reflect.apply(String.fromCharCode, null, signs.subarray(at, at + width))
  }
}

/** The rows of a map one by one, `.` free, `#` obstacle or what sign else is given for it. */
export const rowByRow = (grid: Grid, obstacle = '#'): Generator<string, void, void> =>
  rowsOf(signs(grid, obstacle.charCodeAt(0)), grid)

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
      throw unequalRows(y, row.length, width)
    }
    for (let x = 0; x < width; x++) {
      const code = row.charCodeAt(x)
      if (code === SIGN.obstacle) walls[y * width + x] = 1
      else if (code !== SIGN.free) {
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

/**
 * The text map of a problem: what `problemFromText` reads. A start on the goal shows as `G`.
 * @throws InputError as `checkProblem` does.
 */
export function problemToText(problem: Problem): string {
  checkProblem(problem)
  const { grid, start, goal } = problem
  const cells = signs(grid, SIGN.obstacle)
  cells[start] = SIGN.start
  cells[goal] = SIGN.goal
  return `${[...rowsOf(cells, grid)].join('\n')}\n`
}

function unequalRows(y: number, length: number, width: number): InputError {
  return new InputError(
    `Row ${y + 1} has ${length} ${plural(length, 'cell')}, but row 1 has ${width}.`,
  )
}
