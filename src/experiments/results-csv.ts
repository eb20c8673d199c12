import { InputError } from '../grid/errors'
import { describe, excerpt } from '../grid/excerpt'
import { inParts } from './in-parts'
import { readRows } from './read-rows'
import { originToJson, type Results, readOrigin } from './results'
import type { Row } from './row'

type Value = string | number | boolean | null

/** Columns named after the row's fields; "start.x", "mapParams.density", "params.leave" lie within one. */
const COLUMNS = [
  'map',
  'family',
  'mapParams',
  'width',
  'height',
  'density',
  'mapSeed',
  'start.x',
  'start.y',
  'goal.x',
  'goal.y',
  'distance',
  'tooNear',
  'reachable',
  'optimumCells',
  'optimumLength',
  'setting',
  'planner',
  'params',
  'seed',
  'status',
  'cells',
  'length',
  'turns',
  'steps',
  'ratio',
  'expanded',
  'sensed',
  'bound',
  'milliseconds',
] as const

/** Columns whose values are words, whatever they look like. */
const WORDS: ReadonlySet<string> = new Set(['family', 'planner', 'status'])

/** Results as a table of values separated by commas: all parts of `csvInParts` together. */
export const resultsToCsv = (results: Results): string => [...csvInParts(results)].join('')

/**
 * Results as a table of values separated by commas (RFC 4180), a part of its text after the other. A
 * comment before the names of the columns has the settings; most programs skip it if told that "#" begins
 * a comment. Spreadsheets take it for a value: it is JSON, percent-encoded, and so has nothing in it
 * that they would split or change when they save the table.
 */
export function* csvInParts(
  { rows, ...origin }: Results,
  progress?: (done: number) => void,
): Generator<string, void, void> {
  const columns = columnsOf(rows)
  const names = columns.map(({ name }) => name)
  yield `# ${encodeURIComponent(JSON.stringify(originToJson(origin)))}\n${names.join(',')}\n`
  const line = (row: Row) => `${columns.map(({ of }) => quoted(of(row))).join(',')}\n`
  yield* inParts(rows, line, '', progress)
}

/**
 * The results in a table that `resultsToCsv` wrote, also if a spreadsheet saved it again: with quotes,
 * with semicolons or tabs between the values, and then perhaps with decimal commas in them. It yields
 * what share of the rows is read.
 * @throws InputError that names the line that is wrong
 */
export function* resultsFromCsv(text: string): Generator<number, Results, void> {
  const whole = text.replaceAll('\r\n', '\n').replace(/\n+$/, '')
  const [comment, header = '', ...lines] = whole.split('\n')
  const origin = readOrigin(settingsIn(comment))
  const separator = /[,;\t]/.exec(header)?.[0] ?? ','
  const splitLine = lineSplitter(separator)
  const names = splitLine(header, 'Line 2')
  const nameOf = (i: number) => `Line ${i + 3}`
  const jsonOf = (line: string, i: number) => {
    const values = splitLine(line, nameOf(i))
    if (values.length !== names.length) {
      throw new InputError(
        `${nameOf(i)} has ${values.length} values, but there are ${names.length} columns.`,
      )
    }
    const row = names.map(
      (name, k) => [name, WORDS.has(name) ? values[k] : valueIn(values[k], separator)] as const,
    )
    return unflatten(Object.fromEntries(row))
  }
  return { ...origin, rows: yield* readRows(origin, lines, jsonOf, nameOf) }
}

interface Column {
  readonly name: string
  of(row: Row): Value
}

/** The comment alone in its line, or as its first value, before empty ones; perhaps all in quotes. */
const COMMENT = /^"?# (%7B[^",;\t]*)[",;\t]*$/

/** Older versions wrote the JSON as it is, of which no spreadsheet leaves the quotes alone. */
function settingsIn(comment: string): unknown {
  try {
    const encoded = COMMENT.exec(comment)?.[1]
    if (encoded !== undefined) return JSON.parse(decodeURIComponent(encoded))
    if (comment.startsWith('# ')) return JSON.parse(comment.slice(2))
  } catch {}
  throw new InputError(
    `Line 1 must be "# " and the settings, but is ${excerpt(comment)}. If another program saved the table, open the results as they were saved here.`,
  )
}

/** All columns; those of parameters in the order in which they appear. */
function columnsOf(rows: readonly Row[]): Column[] {
  return COLUMNS.flatMap((name): Column[] => {
    switch (name) {
      case 'start.x':
        return [{ name, of: ({ start }) => start[0] }]
      case 'start.y':
        return [{ name, of: ({ start }) => start[1] }]
      case 'goal.x':
        return [{ name, of: ({ goal }) => goal[0] }]
      case 'goal.y':
        return [{ name, of: ({ goal }) => goal[1] }]
      case 'mapParams':
      case 'params': {
        const inner = new Set<string>()
        for (const row of rows) for (const param of Object.keys(row[name])) inner.add(param)
        return Array.from(inner, (param) => ({
          name: `${name}.${param}`,
          of: (row) => row[name][param] ?? null,
        }))
      }
      default:
        return [{ name, of: (row) => row[name] }]
    }
  })
}

function unflatten(flat: Readonly<Record<string, Value>>): unknown {
  const row: Record<string, unknown> = {
    start: [flat['start.x'], flat['start.y']],
    goal: [flat['goal.x'], flat['goal.y']],
    mapParams: {},
    params: {},
  }
  for (const [name, value] of Object.entries(flat)) {
    const [field, inner] = name.split('.')
    if (field === 'start' || field === 'goal') continue
    if (inner === undefined) row[field] = value
    else if (value !== null) row[field] = { ...Object(row[field]), [inner]: value }
  }
  return row
}

function quoted(value: Value): string {
  const text = value === null ? '' : String(value)
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}

/** What finds the values in a line that has a comma, a semicolon or a tab between them; `name` is its own. */
function lineSplitter(separator: string): (line: string, name: string) => string[] {
  const part = new RegExp(
    `(?:"((?:[^"]|"")*)"|([^"${separator}][^${separator}]*)?)(${separator}|$)`,
    'y',
  )
  return (line, name) => {
    const values: string[] = []
    part.lastIndex = 0
    for (let end = separator; end === separator; ) {
      const found = part.exec(line)
      if (!found) {
        throw new InputError(`${name} has a quote that is not closed: ${describe(line)}.`)
      }
      values.push(found[1]?.replaceAll('""', '"') ?? found[2] ?? '')
      end = found[3]
    }
    return values
  }
}

/** Spreadsheets write TRUE, and where numbers have decimal commas, something else between values. */
function valueIn(text: string, separator: string): Value {
  if (text === '') return null
  if (/^(true|false)$/i.test(text)) return text.toLowerCase() === 'true'
  const number = Number(separator === ',' ? text : text.replace(/^(\d+),(\d+(e-?\d+)?)$/i, '$1.$2'))
  return Number.isNaN(number) ? text : number
}
