import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { isAsStated, misstated, readScenarioMaps } from '../../bench/planners/movingai'

let folder = ''
const file = (name: string, text: string) => {
  writeFileSync(join(folder, name), text)
  return join(folder, name)
}
const MAP = 'type octile\nheight 3\nwidth 4\nmap\n....\n.@T.\nG..S\n'
const scenarios = (...lines: string[]) => `version 1\n${lines.join('\n')}\n`

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'bench-'))
})
afterAll(() => rmSync(folder, { recursive: true }))

test('lengths that are not the stated ones are told, for every search', () => {
  const map = file('a.map', MAP)
  const scen = file(
    'a.map.scen',
    scenarios('0\tmaps/a.map\t4\t3\t0\t0\t3\t2\t5', '0\tmaps/a.map\t4\t3\t0\t0\t3\t2\t4.41421'),
  )
  const [read] = readScenarioMaps([map], [scen])
  expect(read.map.queries).toEqual([
    { start: 0, goal: 11 },
    { start: 0, goal: 11 },
  ])
  expect(misstated(read)).toEqual(
    ['dijkstra', 'a-star', 'jump-point'].map(
      (search) => `a.map (0, 0) to (3, 2): decomposition ${search} reached, 5; stated 4.41421`,
    ),
  )
})

test('files that do not fit together are refused', () => {
  const map = file('b.map', MAP)
  const other = file('b.map.scen', scenarios('0\tc.map\t4\t3\t0\t0\t3\t2\t5'))
  const large = file('d.map.scen', scenarios('0\tb.map\t5\t3\t0\t0\t3\t2\t5'))
  const right = file('e.map.scen', scenarios('0\tb.map\t4\t3\t0\t0\t3\t2\t5'))
  expect(() => readScenarioMaps([map], [])).toThrow('No scenario file asks anything on b.map.')
  expect(() => readScenarioMaps([map], [right, other])).toThrow('ask for c.map')
  expect(() => readScenarioMaps([map], [large])).toThrow('b.map is 4 × 3, not 5 × 3')
  expect(() => readScenarioMaps([right], [])).toThrow('e.map.scen: The map ends in its header')
})

test.each([
  ['begins', '1\t1\t3\t2'],
  ['ends', '0\t0\t2\t1'],
])('a scenario that %s on an obstacle is refused', (_, ends) => {
  const map = file('f.map', MAP)
  const scen = file('f.map.scen', scenarios(`0\tf.map\t4\t3\t${ends}\t5`))
  expect(() => readScenarioMaps([map], [scen])).toThrow(/f\.map has an obstacle at \([12], 1\)/)
})

test('both files may begin with a byte order mark', () => {
  const map = file('g.map', `\uFEFF${MAP}`)
  const scen = file('g.map.scen', `\uFEFF${scenarios('0\tg.map\t4\t3\t0\t0\t3\t2\t5')}`)
  const [read] = readScenarioMaps([map], [scen])
  expect(misstated(read)).toEqual([])
})

test('a length is as stated if its printed digits are the same', () => {
  const root = Math.SQRT2
  expect(isAsStated(2 + root, 3.41421)).toBe(true)
  expect(isAsStated(2 + root, 3.41422)).toBe(false)
  expect(isAsStated(2 + root, 3.41421356)).toBe(true)
  expect(isAsStated(2 + root, 3.41421366)).toBe(false)
  // An integer is printed without the zeros behind the point.
  expect(isAsStated(4, 4)).toBe(true)
  expect(isAsStated(4.0001, 4)).toBe(false)
  expect(isAsStated(100 + 20 * root, 128.284)).toBe(true)
  expect(isAsStated(0, 0)).toBe(true)
  expect(isAsStated(1, 0)).toBe(false)
})
