import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { generators } from '../../../src/grid/generators'
import { pointOf } from '../../../src/grid/grid'
import { rowByRow } from '../../../src/grid/text-map'
import { checkProblem, type DiagonalRule, InputError } from '../../../src/index'
import { RULES } from '../arbitraries'
import { make, seeds, sizes } from './maps'

test('four generators, each with an id of its own', () => {
  expect(generators.map(({ id }) => id)).toEqual(['random', 'blocks', 'rooms', 'maze'])
})

describe.each(generators)('$id', (generator) => {
  const params = fc.record(
    Object.fromEntries(
      generator.params.map(({ name, min, max }) => [name, fc.integer({ min, max })]),
    ),
  )

  test('its parameters are declared soundly', () => {
    for (const { name, label, min, max, default: usual, help } of generator.params) {
      expect([name, label, help]).not.toContain('')
      expect(min).toBeLessThanOrEqual(usual)
      expect(usual).toBeLessThanOrEqual(max)
    }
  })

  test('makes a sound problem of any size: start on the left, goal on the right, both free', () => {
    fc.assert(
      fc.property(sizes, params, seeds, fc.constantFrom(...RULES), (size, values, seed, rule) => {
        const problem = generator.generate(size, values, seed, rule)
        checkProblem(problem)
        const { grid, start, goal, diagonal } = problem
        expect([grid.width, grid.height, diagonal]).toEqual([size.width, size.height, rule])
        expect(pointOf(grid.width, start).x).toBeLessThan(grid.width / 2)
        expect(pointOf(grid.width, goal).x).toBeGreaterThanOrEqual((grid.width - 1) / 2)
        expect(start).not.toBe(goal)
        expect(grid.walls.every((wall) => wall === 0 || wall === 1)).toBe(true)
      }),
      { numRuns: 500 },
    )
  })

  const size = { width: 31, height: 22 }
  const rule: DiagonalRule = 'only-when-no-obstacles'

  test('the same seed makes the same map, another seed another', () => {
    const maps = [1, 1, 2, -1].map((seed) => generator.generate(size, {}, seed, rule))
    expect(maps[0]).toEqual(maps[1])
    expect(maps[0].grid).not.toEqual(maps[2].grid)
    expect(maps[2].grid).not.toEqual(maps[3].grid)
  })

  test('a parameter that is missing has its default', () => {
    const usual = Object.fromEntries(generator.params.map((param) => [param.name, param.default]))
    expect(generator.generate(size, {}, 5, rule)).toEqual(generator.generate(size, usual, 5, rule))
  })

  test('what does not fit is named', () => {
    const [{ name, label, min, max }] = generator.params
    const generate =
      (width: number, values: Record<string, number>, seed = 1) =>
      () =>
        generator.generate({ width, height: 10 }, values, seed, rule)
    const cases: [() => unknown, string][] = [
      [generate(1, {}), "The map's width is 1"],
      [generate(2049, {}), "The map's width is 2049"],
      [generate(10, { [name]: min - 1 }), `${label} is ${min - 1}: it must be a whole number`],
      [generate(10, { [name]: max + 1 }), `from ${min} to ${max}.`],
      [generate(10, { [name]: min + 0.5 }), `${label} is ${min + 0.5}`],
      [generate(10, { [name]: Number.NaN }), `${label} is NaN`],
      [generate(10, { colour: 1 }), 'has no parameter "colour".'],
      [generate(10, {}, 0.5), 'The seed 0.5 is not a whole number.'],
    ]
    for (const [run, message] of cases) {
      expect(run).toThrow(InputError)
      expect(run).toThrow(message)
    }
  })

  test('makes the largest map too', () => {
    const largest = { width: 2048, height: 2048 }
    const problem = generator.generate(largest, {}, 1, rule)
    checkProblem(problem)
    expect(problem.grid).toMatchObject(largest)
  })
})

// Settings files, links and results name maps by their seeds.
describe('the map of a seed is the same in every version', () => {
  test.each([
    [
      'random',
      { density: 25 },
      `
        ...#..#...##..###...#...
        #.....#...#.#....#.....#
        ..........##.....#.....#
        .....#...####.#...#.#..#
        ...####..#.#...#.####...
        #......#.............#..
        ...##..##..#...#..#.#...
        ..#..#............#.....
        ......#.......#.#......#
      `,
    ],
    [
      'blocks',
      { density: 30, largest: 5, hollow: 60 },
      `
        .###..##...###..........
        ####..####....###.......
        ####..####....##.#.....#
        ###......#.###.###......
        #.#......#.#..##.#......
        ...#.....#.#.####.......
        ...#....................
        ...#....###............#
        ..##....#.#............#
      `,
    ],
    [
      'rooms',
      { room: 3 },
      `
        .......#....#....#......
        .......#....#...........
        .......#....#....#......
        .......#.#####.###......
        ............#....#####.#
        ###.####....#....#......
        .......#....#....#......
        .......#....#....#......
        .......#.........#......
      `,
    ],
    [
      'maze',
      { loops: 20 },
      `
        .........#.........#....
        .#.#####.#####.###.#.###
        .#.#...#.......#.#.#....
        .#.#.#.#.#.#####.#.#.#.#
        .....#.#...#.........#..
        .###.#.#####.###.#.###.#
        ...........#...#........
        .#.###.###.#.#.#.#.###.#
        ........................
      `,
    ],
  ])('%s', (id, params, rows) => {
    const { grid } = make(id, { width: 24, height: 9 }, params, 3)
    expect([...rowByRow(grid)]).toEqual(rows.trim().split(/\s+/))
  })
})
