import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { gridFromRows } from '../../src/grid/text-map'
import { type DiagonalRule, InputError, problemFromText, problemToText } from '../../src/index'
import { problems } from './arbitraries'

test('a text map is read cell by cell', () => {
  expect(problemFromText('S#.\n..G\n')).toEqual({
    grid: { width: 3, height: 2, walls: Uint8Array.of(0, 1, 0, 0, 0, 0) },
    start: 0,
    goal: 5,
    diagonal: 'if-at-most-one-obstacle',
  })
})

test('blank lines around it, blanks beside it and Windows line ends do not count', () => {
  const plain = problemFromText('S#.\n..G')
  expect(problemFromText('\n\n  S#. \r\n  ..G\r\n\r\n')).toEqual(plain)
})

test('what is written is read again', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      fc.pre(problem.start !== problem.goal)
      expect(problemFromText(problemToText(problem), problem.diagonal)).toEqual(problem)
    }),
  )
})

test('a start on the goal is shown as the goal', () => {
  const grid = { width: 2, height: 2, walls: Uint8Array.of(0, 1, 0, 0) }
  const text = problemToText({ grid, start: 2, goal: 2, diagonal: 'only-when-no-obstacles' })
  expect(text).toBe('.#\nG.\n')
})

describe('what is wrong is named with its place', () => {
  test.each([
    ['', "The map's width is 0"],
    ['SG', "The map's height is 1"],
    ['S\nG', "The map's width is 1"],
    ['S..\n..', 'Row 2 has 2 cells, but row 1 has 3.'],
    ['S..\n.', 'Row 2 has 1 cell, but row 1 has 3.'],
    ['S..\n.x.\n..G', '"x" at (1, 1) is no cell: use "#" obstacle'],
    ['S..\n.🙂.\n..G', 'Row 2 has 4 cells, but row 1 has 3.'],
    ['S..\n🙂.\n..G', '"🙂" at (0, 1) is no cell'],
    ['S..\n.\u0000.\n..G', '"·" at (1, 1) is no cell'],
    ['S..\n.S.\n..G', 'A second "S" at (1, 1).'],
    ['SG.\n.G.', 'A second "G" at (1, 1).'],
    ['...\n..G', 'The map has no start ("S").'],
    ['...\n..S', 'The map has no goal ("G").'],
  ])('%j', (text, message) => {
    expect(() => problemFromText(text)).toThrow(InputError)
    expect(() => problemFromText(text)).toThrow(message)
  })
})

test('rows of a map are its obstacles and free cells, and nothing else', () => {
  expect(gridFromRows(['.#', '..', '##'])).toEqual({
    width: 2,
    height: 3,
    walls: Uint8Array.of(0, 1, 0, 0, 1, 1),
  })
  const cases: [readonly unknown[], string][] = [
    [[], "The map's width is 0"],
    [['..', '.S.'], 'Row 2 has 3 cells, but row 1 has 2.'],
    [['..', '.S'], '"S" at (1, 1) is no cell: use "#" obstacle, "." free.'],
    [['...', 'xyz'], '"x" at (0, 1) is no cell'],
    [['..', 3], 'Row 2 must be a text of "#" and ".", but is 3.'],
    [[null, '..'], 'Row 1 must be a text of "#" and ".", but is null.'],
  ]
  for (const [rows, message] of cases) {
    expect(() => gridFromRows(rows)).toThrow(InputError)
    expect(() => gridFromRows(rows)).toThrow(message)
  }
})

test('what is no text, and a rule that is none, are refused', () => {
  const rows = ['S.', '.G'] as unknown as string
  expect(() => problemFromText(rows)).toThrow('A text is needed, but this is [')
  expect(() => problemFromText(rows)).toThrow(InputError)
  const never = 'never' as unknown as DiagonalRule
  expect(() => problemFromText('S.\n.G', never)).toThrow('The diagonal rule "never" is unknown')
})
