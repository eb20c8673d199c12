import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { openMap } from '../../../src/grid/formats/open-map'
import { saveProject } from '../../../src/grid/formats/project-file'
import { checkProblem, InputError, type Problem, problemToText } from '../../../src/index'
import { problems } from '../arbitraries'
import { mustRefuse, whole } from './files'
import { project } from './sound-file'

describe("the project's own file", () => {
  test('is opened as it was saved', () => {
    fc.assert(
      fc.property(problems, (problem) => {
        expect(openMap(whole(saveProject(problem)))).toEqual({ problem, notes: [] })
      }),
    )
  })

  test('can be read by a person', () => {
    const problem: Problem = {
      grid: { width: 3, height: 2, walls: Uint8Array.of(0, 0, 1, 1, 0, 0) },
      start: 0,
      goal: 5,
      diagonal: 'only-when-no-obstacles',
    }
    expect(whole(saveProject(problem))).toBe(`{
  "format": "path-planner",
  "version": 1,
  "diagonal": "only-when-no-obstacles",
  "start": [0, 0],
  "goal": [2, 1],
  "rows": [
    "..#",
    "#.."
  ]
}
`)
  })

  test('may be laid out in any way, and begin with a byte order mark', () => {
    const { problem } = openMap(project())
    expect(problem.grid.walls).toEqual(Uint8Array.of(0, 0, 1, 1, 0, 0))
    expect(openMap(`\uFEFF\r\n ${JSON.stringify(JSON.parse(project()), null, '\t')}`)).toEqual({
      problem,
      notes: [],
    })
  })

  test.each<[string, object, string]>([
    [
      'of a later version',
      { version: 2 },
      'This file is of version 2; this program reads version 1.',
    ],
    ['of version "1"', { version: '1' }, '"version" must be a whole number, but is "1".'],
    ['without version', { version: undefined }, '"version" is missing: it must be a whole number.'],
    [
      'of another format',
      { format: 'tiled' },
      'The "format" of this file is "tiled", not "path-planner".',
    ],
    ['of no format', { format: null }, 'The "format" of this file is null'],
    [
      'with an unknown rule',
      { diagonal: 'always' },
      '"diagonal" must be "if-at-most-one-obstacle" or "only-when-no-obstacles", but is "always".',
    ],
    [
      'without start',
      { start: undefined },
      '"start" is missing: it must be two whole numbers, [x, y].',
    ],
    ['with a start of texts', { start: ['0', 0] }, 'but is ["0", 0].'],
    [
      'with half a start',
      { start: [0.5, 0] },
      '"start" must be two whole numbers, [x, y], but is [0.5, 0].',
    ],
    ['with a start of three numbers', { start: [0, 0, 0] }, 'but is [0, 0, 0].'],
    ['with a start that is an object', { start: { x: 0, y: 0 } }, 'but is an object.'],
    ['with a goal beside the map', { goal: [3, 0] }, 'The goal (3, 0) is not on the 3 × 2 map.'],
    ['with a goal left of the map', { goal: [-1, 1] }, 'The goal (-1, 1) is not on the 3 × 2 map.'],
    ['with a goal far out', { goal: [1e300, 0] }, 'is not on the 3 × 2 map.'],
    ['with a start on an obstacle', { start: [2, 0] }, 'The start (2, 0) is an obstacle.'],
    ['with a goal on an obstacle', { goal: [0, 1] }, 'The goal (0, 1) is an obstacle.'],
    ['without rows', { rows: undefined }, '"rows" is missing: it must be a list of texts'],
    ['with rows that are a text', { rows: '..#' }, 'but is "..#".'],
    ['with no row', { rows: [] }, "The map's width is 0"],
    ['with one row', { rows: ['...'] }, "The map's height is 1"],
    ['with too many rows', { rows: new Array(2049).fill('..') }, "The map's height is 2049"],
    ['with rows too long', { rows: ['.'.repeat(2049), '..'] }, "The map's width is 2049"],
    ['with a row too short', { rows: ['...', '...', '..'] }, 'Row 3 has 2 cells, but row 1 has 3.'],
    ['with a row of numbers', { rows: ['...', [0, 0, 0]] }, 'Row 2 must be a text of "#" and "."'],
    [
      'with a first row of numbers',
      { rows: [5, '...'] },
      'Row 1 must be a text of "#" and ".", but is 5.',
    ],
    ['with a foreign sign', { rows: ['...', '.S.'] }, '"S" at (1, 1) is no cell: use "#" obstacle'],
  ])('%s is refused', (_, change, message) => {
    mustRefuse(project(change), message)
  })

  test('numbers that JSON cannot hold are no numbers of the map', () => {
    mustRefuse(project().replace('[0,0]', '[1e999,0]'), '"start" must be two whole numbers')
  })

  test('a project file cut off anywhere, or with any sign exchanged, opens or is refused', () => {
    const sound = whole(saveProject(openMap(project()).problem))
    const open = (text: string) => {
      try {
        checkProblem(openMap(text).problem)
      } catch (error) {
        expect(error, text).toBeInstanceOf(InputError)
      }
    }
    for (let at = 0; at < sound.trimEnd().length; at++) {
      expect(() => openMap(sound.slice(0, at))).toThrow(InputError)
      for (const put of ['', '0', '-', '9', '#', '.', '"', '{', ']', ',', '\n']) {
        open(sound.slice(0, at) + put + sound.slice(at + 1))
      }
    }
  })

  test('the largest map is saved and opened', () => {
    const side = 2048
    const walls = Uint8Array.from({ length: side * side }, (_, i) => (i % 7 === 3 ? 1 : 0))
    const grid = { width: side, height: side, walls }
    const problem: Problem = {
      grid,
      start: 0,
      goal: side * side - 1,
      diagonal: 'only-when-no-obstacles',
    }
    const opened = openMap(whole(saveProject(problem))).problem
    expect(Buffer.compare(opened.grid.walls, walls)).toBe(0)
    expect({ ...opened, grid: null }).toEqual({ ...problem, grid: null })
    expect(() => openMap(problemToText(problem))).not.toThrow()
  })
})
