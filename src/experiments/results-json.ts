import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import { parseJson } from '../grid/formats/json'
import { inParts } from './in-parts'
import { readRows } from './read-rows'
import { type Origin, originToJson, type Results, readOrigin } from './results'
import type { Row } from './row'

/** The first of the JSON lines, without its end: what the rows after it come from. */
export const originToLine = (origin: Origin): string => JSON.stringify(originToJson(origin))

/** The JSON line of a row, without its end. */
export const rowToLine = (row: Row): string => JSON.stringify(row)

/** Results as JSON lines: the settings, then a row a line. What the command line writes. */
export function resultsToLines({ rows, ...origin }: Results): string {
  return [originToLine(origin), ...rows.map(rowToLine), ''].join('\n')
}

/**
 * The results in JSON lines. A last line without an end is left out: that run was broken off there.
 * It yields what share of the rows is read.
 * @throws InputError that names the line that is wrong
 */
export function* resultsFromLines(text: string): Generator<number, Results, void> {
  const [first, ...others] = text.split('\n')
  const origin = readOrigin(parseLine(first, 1))
  others.pop()
  const jsonOf = (line: string, i: number) => parseLine(line, i + 2)
  return { ...origin, rows: yield* readRows(origin, others, jsonOf, (i) => `Line ${i + 2}`) }
}

/**
 * The JSON value of one of many lines.
 * @param number of the line, from 1
 */
export function parseLine(line: string, number: number): unknown {
  try {
    return JSON.parse(line)
  } catch {
    throw new InputError(`Line ${number} is no JSON: ${describe(line)}.`)
  }
}

/** Results as one JSON object: all parts of `jsonInParts` together. */
export const resultsToJson = (results: Results): string => [...jsonInParts(results)].join('')

/** Results as one JSON object, with a row a line, a part of its text after the other. */
export function* jsonInParts(
  { rows, ...origin }: Results,
  progress?: (done: number) => void,
): Generator<string, void, void> {
  yield `${JSON.stringify({ ...originToJson(origin), rows: [] }).slice(0, -2)}\n`
  yield* inParts(rows, rowToLine, ',\n', progress)
  yield '\n]}\n'
}

/**
 * The results in a JSON object that `resultsToJson` wrote. It yields what share of the rows is read.
 * @throws InputError that names the place that is not JSON, or the row that is wrong
 */
export function* resultsFromJson(text: string): Generator<number, Results, void> {
  const value = Object(parseJson(text))
  const origin = readOrigin(value)
  if (!Array.isArray(value.rows)) throw new InputError('"rows" must be a list.')
  const jsonOf = (row: unknown) => row
  return { ...origin, rows: yield* readRows(origin, value.rows, jsonOf, (i) => `Row ${i}`) }
}
