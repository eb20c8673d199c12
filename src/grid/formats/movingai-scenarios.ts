import { InputError } from '../errors'
import { describe, excerpt } from '../excerpt'
import type { Point } from '../grid'

/** One line of a MovingAI scenario file: a problem on a map, and how long its shortest path is. */
export interface Scenario {
  readonly bucket: number
  /** The map's file, as the scenario names it, and its size in cells. */
  readonly map: string
  readonly width: number
  readonly height: number
  readonly start: Point
  readonly goal: Point
  /** Length of a shortest path in cell sides, as many digits as the file prints. */
  readonly length: number
}

/**
 * The scenarios in a MovingAI `.scen` file. Steps past a corner are not allowed in them: the
 * diagonal rule is `only-when-no-obstacles`.
 * @throws InputError that names the line.
 */
export function readScenarios(text: string): Scenario[] {
  const lines = text.split(/\r?\n/)
  if (!/^version +1(\.0+)?\s*$/.test(lines[0])) {
    throw new InputError(`Line 1 must be "version 1", but is ${excerpt(lines[0])}.`)
  }
  return lines.flatMap((line, i) => (i === 0 || line.trim() === '' ? [] : [readLine(line, i + 1)]))
}

function readLine(line: string, number: number): Scenario {
  const fail = (what: string) => new InputError(`Line ${number} of the scenarios: ${what}.`)
  const whole = (name: string, field: string): number => {
    if (/^\d{1,9}$/.test(field)) return Number(field)
    throw fail(`the ${name} must be a whole number, but is ${describe(field)}`)
  }
  // The fields stand between tabs, in some files between blanks.
  const fields = line.trim().split(line.includes('\t') ? '\t' : / +/)
  if (fields.length !== 9) throw fail(`expected 9 fields, but there are ${fields.length}`)
  const [bucket, map, columns, rows, startX, startY, goalX, goalY, length] = fields
  const width = whole('width', columns)
  const height = whole('height', rows)
  const place = (name: string, column: string, row: string): Point => {
    const [x, y] = [whole(`${name} x`, column), whole(`${name} y`, row)]
    if (x < width && y < height) return { x, y }
    throw fail(`the ${name} (${x}, ${y}) is not on the ${width} × ${height} map`)
  }
  // With more digits it could be beyond all numbers, and every length would be as stated.
  if (!/^\d{1,9}(\.\d+)?$/.test(length)) {
    throw fail(`the optimal length must be a number, but is ${describe(length)}`)
  }
  return {
    bucket: whole('bucket', bucket),
    map,
    width,
    height,
    start: place('start', startX, startY),
    goal: place('goal', goalX, goalY),
    length: Number(length),
  }
}
