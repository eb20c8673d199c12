import { expect, test } from 'vitest'
import { readCommand } from '../../bench/planners/command'

const nothing = { help: false, quick: false, docs: false, only: '', maps: [], scenarios: [] }

test('the command line is read', () => {
  expect(readCommand([])).toEqual(nothing)
  expect(readCommand(['--quick', '--only', 'a-star'])).toEqual({
    ...nothing,
    quick: true,
    only: 'a-star',
  })
  expect(readCommand(['a.map', 'a.map.scen'])).toEqual({
    ...nothing,
    maps: ['a.map'],
    scenarios: ['a.map.scen'],
  })
  expect(readCommand(['--docs']).docs).toBe(true)
})

test.each([
  [['a.txt'], 'a.txt is neither a .map nor a .scen file'],
  [['--fast'], '--fast'],
  [['a.map', 'a.map.scen', '--only', 'dijkstra'], 'no files with them'],
  [['a.map', 'a.map.scen', '--quick'], 'no files with them'],
  [['--docs', '--quick'], '--docs'],
  [['--docs', '--only', 'a'], '--docs'],
])('%j is refused', (args, message) => {
  expect(() => readCommand(args)).toThrow(message)
})
