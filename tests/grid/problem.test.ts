import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  bug1Bound,
  bug2Bound,
  checkProblem,
  InputError,
  type Problem,
  plan,
  problemToText,
} from '../../src/index'
import { problems } from './arbitraries'

const RULE = 'only-when-no-obstacles'

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
  const walls = (...cells: number[]) => ({
    grid: { ...sound.grid, walls: Uint8Array.from(cells) },
  })
  const cases: [string, Partial<Problem>, string][] = [
    ['too narrow', side(1), "The map's width is 1: it must be a whole number from 2 to 2048."],
    ['too wide', side(2049), "The map's width is 2049"],
    ['too high', side(3, 1e9), "The map's height is 1000000000"],
    ['half a cell', side(2.5), "The map's width is 2.5"],
    ['not a number', side(Number.NaN), "The map's width is NaN"],
    ['cells missing', side(4), 'The map has 6 cells, but 4 × 2 make 8.'],
    // As masks of pictures have it; taken for obstacles by some and for free cells by others.
    ['another obstacle', walls(0, 0, 255, 0, 0, 0), 'The cell (2, 0) is 255: it must be 0, free,'],
    ['another one, late', walls(0, 0, 0, 0, 2, 0), 'The cell (1, 1) is 2: it must be 0, free,'],
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

test('a map that was sound before is read again', () => {
  const problem: Problem = {
    grid: { width: 3, height: 2, walls: Uint8Array.of(0, 0, 1, 0, 0, 0) },
    start: 0,
    goal: 5,
    diagonal: RULE,
  }
  for (const planner of ['bug2', 'decomposition']) {
    expect(plan(problem, planner).status).toBe('reached')
    problem.grid.walls[2] = 255
    expect(() => plan(problem, planner)).toThrow('The cell (2, 0) is 255')
    problem.grid.walls[2] = 1
  }
})

test.each([
  undefined,
  null,
  3,
  {},
  { grid: null },
  { grid: { width: 2, height: 2, walls: [0, 0, 0, 0] }, start: 0, goal: 3 },
])('what is no problem is refused by all that take one: %j', (value) => {
  const problem = value as unknown as Problem
  const message = 'The problem has no map: its "grid" must have "walls", a Uint8Array.'
  const askers = [checkProblem, problemToText, bug2Bound]
  for (const ask of [...askers, () => plan(problem, 'bug1'), () => bug1Bound(problem, 'left')]) {
    expect(() => ask(problem)).toThrow(InputError)
    expect(() => ask(problem)).toThrow(message)
  }
})

test('a map is looked at anew if it differs from the one before, be it in its last cell', () => {
  const wallsWith = (last: number) => {
    const walls = new Uint8Array(35)
    walls[34] = last
    return walls
  }
  const planOn = (walls: Uint8Array, id: string) => () =>
    plan({ grid: { width: 7, height: 5, walls }, start: 0, goal: 33, diagonal: RULE }, id)
  for (const id of ['decomposition', 'bug1', 'potential-field', 'visibility-graph']) {
    for (const last of [0, 1, 1, 0]) expect(planOn(wallsWith(last), id)).not.toThrow()
    expect(planOn(wallsWith(128), id)).toThrow('The cell (6, 4) is 128')
    expect(planOn(wallsWith(128), id)).toThrow(InputError)
  }
})

test('a value that is neither free nor obstacle is named, whichever cell has it', () => {
  // Large enough to be looked at several cells at a time, and then one by one.
  for (let cell = 0; cell < 49; cell++) {
    const walls = new Uint8Array(49)
    walls[cell] = 2
    const grid = { width: 7, height: 7, walls }
    const problem = { grid, start: 0, goal: 48, diagonal: 'if-at-most-one-obstacle' } as const
    const name = `(${cell % 7}, ${Math.floor(cell / 7)})`
    expect(() => checkProblem(problem)).toThrow(`The cell ${name} is 2: it must be 0, free,`)
  }
})
