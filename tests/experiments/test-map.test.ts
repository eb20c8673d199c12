import { expect, test } from 'vitest'
import { cellName, checkProblem, InputError, testMap } from '../../src/index'
import { settingsWith } from './settings'

const settings = settingsWith()
const maps = Array.from({ length: 30 }, (_, number) => testMap(settings, number))

test('a map is a sound problem, with start and goal at the least distance', () => {
  for (const { problem, distance, tooNear } of maps) {
    checkProblem(problem)
    const { grid, start, goal } = problem
    const [sx, sy, gx, gy] = [start, goal].flatMap((cell) => [
      cell % grid.width,
      Math.floor(cell / grid.width),
    ])
    expect(Math.max(Math.abs(sx - gx), Math.abs(sy - gy))).toBe(distance)
    expect(distance).toBeGreaterThanOrEqual(4)
    expect(tooNear).toBe(false)
  }
})

test('kinds of maps take turns', () => {
  const names = maps.map(({ kind }) => JSON.stringify([kind.family, kind.params, kind.size]))
  expect(new Set(names).size).toBe(10)
  for (let i = 10; i < 30; i++) expect(names[i]).toBe(names[i - 10])
})

test('the same number is the same map, others differ in everything that chance decides', () => {
  expect(testMap(settings, 11)).toEqual(maps[11])
  for (const value of ['seed', 'plannerSeed'] as const) {
    expect(new Set(maps.map((map) => map[value])).size).toBe(30)
  }
  const generated = maps.filter(({ kind }) => !kind.given)
  expect(new Set(generated.map(({ problem }) => String(problem.grid.walls))).size).toBe(24)
  expect(testMap({ ...settings, seed: 8 }, 11).problem.grid).not.toEqual(maps[11].problem.grid)
})

test('start and goal fall everywhere, also when any distance will do', () => {
  const any = settingsWith({
    families: [{ family: 'random', params: { density: [0] } }],
    sizes: [[4, 4]],
    mapsPerCombination: 400,
    leastDistance: 1,
  })
  const seen = new Set<string>()
  for (let number = 0; number < 400; number++) {
    const { grid, start } = testMap(any, number).problem
    seen.add(cellName(grid.width, start))
  }
  expect(seen.size).toBe(16)
})

test('a map without room for the least distance has the farthest ends, and says so', () => {
  const rows = ['..########', '..########']
  const tight = settingsWith({
    families: [{ family: 'maps', maps: [{ name: 'tight', rows }] }],
    leastDistance: 9,
  })
  expect(testMap(tight, 0)).toMatchObject({ distance: 1, tooNear: true })
})

test.each([-1, 1.5, Number.NaN, 2 ** 53])('there is no map number %d', (number) => {
  expect(() => testMap(settings, number)).toThrow(InputError)
  expect(() => testMap(settings, number)).toThrow(`The map's number is ${number}`)
})
