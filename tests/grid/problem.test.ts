import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { checkProblem, InputError, type Problem } from '../../src/index'
import { problems } from './arbitraries'

test('a sound problem is accepted', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      checkProblem(problem)
    }),
  )
})

describe('what is wrong is named', () => {
  const sound: Problem = {
    grid: { width: 3, height: 2, walls: Uint8Array.of(0, 0, 1, 0, 0, 0) },
    start: 0,
    goal: 5,
    diagonal: 'if-at-most-one-obstacle',
  }
  const side = (width: number, height = 2): Partial<Problem> => ({
    grid: { width, height, walls: new Uint8Array(6) },
  })
  const cases: [string, Partial<Problem>, string][] = [
    ['too narrow', side(1), "The map's width is 1: it must be a whole number from 2 to 2048."],
    ['too wide', side(2049), "The map's width is 2049"],
    ['too high', side(3, 1e9), "The map's height is 1000000000"],
    ['half a cell', side(2.5), "The map's width is 2.5"],
    ['not a number', side(Number.NaN), "The map's width is NaN"],
    ['cells missing', side(4), 'The map has 6 cells, but 4 × 2 make 8.'],
    ['start off the map', { start: 6 }, 'The start is cell 6, which is not on the 3 × 2 map.'],
    ['start before the map', { start: -1 }, 'The start is cell -1'],
    ['no whole start', { start: 0.5 }, 'The start is cell 0.5'],
    ['goal on an obstacle', { goal: 2 }, 'The goal (2, 0) is an obstacle.'],
    ['no goal', { goal: Number.NaN }, 'The goal is cell NaN'],
    [
      'unknown rule',
      { diagonal: 'never' as Problem['diagonal'] },
      'The diagonal rule "never" is unknown: use if-at-most-one-obstacle or only-when-no-obstacles.',
    ],
  ]

  test.each(cases)('%s', (_, change, message) => {
    const check = () => checkProblem({ ...sound, ...change })
    expect(check).toThrow(InputError)
    expect(check).toThrow(message)
  })
})
