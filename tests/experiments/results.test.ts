import { describe, expect, test } from 'vitest'
import { openingResults } from '../../src/experiments/open-results'
import type { Results } from '../../src/experiments/results'
import { csvInParts } from '../../src/experiments/results-csv'
import { jsonInParts } from '../../src/experiments/results-json'
import {
  InputError,
  openResults,
  resultsToCsv,
  resultsToJson,
  resultsToLines,
  runMap,
} from '../../src/index'
import { settingsWith, timeless } from './settings'

const settings = settingsWith()
const rows = [0, 1, 2, 8, 9].flatMap((map) => runMap(settings, map, () => performance.now()))
const results: Results = { settings, shard: { index: 1, of: 1 }, rows }

const FORMATS = { lines: resultsToLines, json: resultsToJson, csv: resultsToCsv }

describe.each(Object.entries(FORMATS))('%s', (_, write) => {
  test('is opened again, settings and all', () => {
    expect(openResults(write(results))).toEqual(results)
    expect(openResults(`\uFEFF${write(results)}`)).toEqual(results)
  })

  test('is opened in its order, whatever the order of its rows', () => {
    expect(openResults(write({ ...results, rows: rows.toReversed() }))).toEqual(results)
  })

  test('is opened with rests, so that a page can go on meanwhile', () => {
    const first = rows.filter(({ map }) => map === 0)
    const all = Array.from({ length: 30 }, (_, map) => first.map((row) => ({ ...row, map }))).flat()
    const shares = [...openingResults(write({ ...results, rows: all }))]
    expect(shares).toEqual(shares.map((_, i) => (64 * i) / all.length))
    expect(shares.length).toBe(Math.ceil(all.length / 64))
  })

  test('without rows too', () => {
    expect(openResults(write({ ...results, rows: [] }))).toEqual({ ...results, rows: [] })
  })

  test('knows which shard it is', () => {
    const shard = { index: 2, of: 3 }
    expect(openResults(write({ ...results, shard })).shard).toEqual(shard)
  })

  test('has settings inside that give the same rows', () => {
    const opened = openResults(write(results))
    expect(timeless(runMap(opened.settings, 8))).toEqual(
      timeless(rows.filter(({ map }) => map === 8)),
    )
  })

  test('with settings that are broken names the field', () => {
    const broken = write(results).replace(/(seed"?(?:%22)?(?::|%3A))7/, '$1-7')
    expect(() => openResults(broken)).toThrow('seed: must be a whole number')
  })

  test('with a row that is broken names the place', () => {
    const text = write(results)
    const broken = text.replace(/reached(?![\s\S]*reached)/, 'arrived')
    expect(broken).not.toBe(text)
    expect(() => openResults(broken)).toThrow(/^(Line|Row) \d+ is no row .*"status" is "arrived"/)
  })
})

test.each([
  ['CSV', csvInParts, resultsToCsv],
  ['JSON', jsonInParts, resultsToJson],
] as const)('%s of many rows comes in parts that are soon made', (_, inParts, whole) => {
  const many = { ...results, rows: Array.from({ length: 1000 }, (_, i) => rows[i % rows.length]) }
  const told: number[] = []
  const parts = [...inParts(many, (done) => told.push(done))]
  expect(parts.join('')).toBe(whole(many))
  expect(Math.max(...parts.map(({ length }) => length))).toBeLessThan(whole(many).length / 10)
  expect(told.length).toBeGreaterThan(10)
  expect(told).toEqual(told.toSorted((a, b) => a - b))
  expect([told[0], told.at(-1)].every((done) => done !== undefined && done < 1)).toBe(true)
})

describe('rows that are not those of the settings are refused', () => {
  const [first, second] = rows
  test.each([
    ['there twice', [first, second, first], 'Map 0 has two rows of planner setting 0.'],
    ['of another setting', [{ ...first, setting: 99 }], 'Row 0 is of map 0 and of decomposition'],
    ['of another planner', [{ ...first, planner: 'x' }], 'Row 0 is of map 0 and of x as planner'],
    ['of another map', [{ ...first, map: 30 }], 'Row 0 is of map 30'],
    ['a list', [[]], 'Row 0 is no row of results: [].'],
    ['with too much', [{ ...first, more: 1 }], 'there is no field "more"'],
    ['with too little', [{ ...first, status: undefined }], '"status" is missing'],
  ])('%s', (_, list, message) => {
    const text = JSON.stringify({ ...JSON.parse(resultsToJson(results)), rows: list })
    expect(() => openResults(text)).toThrow(InputError)
    expect(() => openResults(text)).toThrow(message)
  })
})

test('CSV has the settings in a comment, the names of the columns, and a line a row', () => {
  const [comment, names, first, ...others] = resultsToCsv(results).split('\n')
  expect(comment).toMatch(/^# [\w%.~!*'()-]+$/)
  expect(JSON.parse(decodeURIComponent(comment.slice(2))).settings).toEqual(settings)
  expect(names).toContain('map,family,mapParams.density')
  expect(names).toContain('params.leave')
  expect(first).toMatch(/^0,random,10,/)
  expect(others).toHaveLength(rows.length)
})

/** A table as a spreadsheet saves it again: its first line has as many values as the others. */
function savedAgain(text: string, separator: string, change: (value: string) => string): string {
  const [comment, names, ...lines] = text.trimEnd().split('\n')
  const empty = names.replaceAll(/[^,]/g, '')
  const anew = (line: string) => line.split(',').map(change).join(separator)
  return [comment + empty, names, ...lines].map((line) => `${anew(line)}\r\n`).join('')
}

const withComma = (value: string) => value.replace(/^(\d+)\.(\d+)$/, '$1,$2')
const inCapitals = (value: string) => value.replace(/^(true|false)$/, (word) => word.toUpperCase())
const inQuotes = (value: string) => (value === '' || /^\d/.test(value) ? value : `"${value}"`)

test.each([
  ['with commas', ',', (value: string) => value],
  ['with commas and quotes', ',', inQuotes],
  ['with tabs and quotes everywhere', '\t', (value: string) => `"${value}"`],
  ['with semicolons and decimal commas', ';', (value: string) => inCapitals(withComma(value))],
  ['with tabs, decimal commas and quotes', '\t', (value: string) => inQuotes(withComma(value))],
])('CSV that a spreadsheet saved again is opened: %s', (_, separator, change) => {
  const saved = savedAgain(resultsToCsv(results), separator, change)
  expect(saved).not.toBe(resultsToCsv(results))
  expect(openResults(saved)).toEqual(results)
  expect(openResults(`\uFEFF${saved}`)).toEqual(results)
  const none = { ...results, rows: [] }
  expect(openResults(savedAgain(resultsToCsv(none), separator, change))).toEqual(none)
})

test('CSV with commas between its values has none in its numbers', () => {
  const [first] = rows
  const saved = resultsToCsv({ ...results, rows: [{ ...first, density: 10.5 }] })
  const odd = saved.replace(',10.5,', ',"10,5",')
  expect(odd).not.toBe(saved)
  expect(() => openResults(odd)).toThrow('Line 3 is no row of results: "density" is "10,5".')
})

test.each(['"random', '"random"x'])('CSV with a quote that is not closed is told of: %s', (odd) => {
  const text = resultsToCsv(results).replace('\n0,random,', `\n0,${odd},`)
  expect(() => openResults(text)).toThrow('Line 3 has a quote that is not closed')
})

test('CSV of older versions, with the settings as they are, is opened', () => {
  const text = resultsToCsv(results)
  const [comment] = text.split('\n')
  expect(openResults(text.replace(comment, decodeURIComponent(comment)))).toEqual(results)
})

test.each(['a "b", c', 'a, b', 'a "b"'])(
  'values with commas and quotes stay whole: %s',
  (family) => {
    const odd = { ...rows[0], family }
    expect(openResults(resultsToCsv({ ...results, rows: [odd] })).rows).toEqual([odd])
  },
)

test('a shard that there cannot be is refused', () => {
  for (const shard of [
    { index: 3, of: 2 },
    { index: 0, of: 2 },
    { index: 1.5, of: 2 },
    { index: 1 },
  ]) {
    const text = resultsToLines(results).replace(/\}\n/, `,"shard":${JSON.stringify(shard)}}\n`)
    expect(() => openResults(text)).toThrow('The "shard" must have an "index" from 1 to "of".')
  }
})

test('JSON may be written anew by other programs', () => {
  const value = JSON.parse(resultsToJson(results))
  expect(openResults(JSON.stringify(value))).toEqual(results)
  expect(openResults(JSON.stringify(value, null, 2))).toEqual(results)
})

test('a last line without an end is left out', () => {
  const whole = resultsToLines(results)
  expect(openResults(whole.slice(0, -30)).rows).toEqual(rows.slice(0, -1))
})

test.each([
  ['', 'The file is broken in line 1'],
  ['{}', 'its "format" is undefined'],
  ['{"format":"path-planner"}', 'its "format" is "path-planner", not "path-planner-results"'],
  ['{"format":"path-planner-results","version":9}', 'of version 9'],
  ['hello', 'The file is broken in line 1, column 1'],
  ['#', 'Line 1 must be "# " and the settings, but is "#".'],
  ['# no', 'but is "# no". If another program saved the table, open the results as they were'],
  ['"# {""settings"":{""seed"":1",maps:2,,', 'but is ""# {""settings""'],
  ['# %7B%22format', 'but is "# %7B%22format"'],
  ['# %7B%2', 'but is "# %7B%2"'],
  ['map,family,density\n0,random,20\n', 'Line 1 must be "# " and the settings, but'],
  ['"map";"family"\n0;"random"\n', 'Line 1 must be "# " and the settings, but'],
])('%j is no results file', (text, message) => {
  expect(() => openResults(text)).toThrow(InputError)
  expect(() => openResults(text)).toThrow(message)
})
