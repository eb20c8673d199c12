import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { problemToText } from '../../../src/index'
import { freeCount, make, pieces, seeds, sizes } from './maps'

const share = (problem: ReturnType<typeof make>): number =>
  100 * (1 - freeCount(problem) / problem.grid.walls.length)

test('the share of obstacles is the density, but for the last block', () => {
  for (const density of [0, 5, 20, 40, 60]) {
    for (const hollow of [0, 50, 100]) {
      const problem = make('blocks', { width: 120, height: 90 }, { density, hollow }, density)
      // The last block covers at most 8 × 8 cells, two cells are freed for start and goal.
      expect(Math.abs(share(problem) - density), `${density} %, ${hollow} %`).toBeLessThan(0.62)
    }
  }
})

test('at density 0 nothing is an obstacle', () => {
  fc.assert(
    fc.property(sizes, seeds, (size, seed) => {
      expect(freeCount(make('blocks', size, { density: 0 }, seed))).toBe(size.width * size.height)
    }),
  )
})

describe('a map of hollow blocks only', () => {
  test('has rooms that are entered by doors: few pieces are cut off', () => {
    const size = { width: 100, height: 100 }
    const settings = { density: 10, largest: 12 }
    const hollow = make('blocks', size, { ...settings, hollow: 100 }, 2)
    const solid = make('blocks', size, { ...settings, hollow: 0 }, 2)
    expect(freeCount(hollow)).toBeGreaterThan(8900)
    expect(pieces(hollow)).toBeLessThan(30)
    const insides = (text: string) => text.split('\n').filter((row) => /#\.+#/.test(row)).length
    expect(insides(problemToText(hollow))).toBeGreaterThan(insides(problemToText(solid)))
  })
})

test('a block is at most as large as asked for', () => {
  const longest = new Set<number>()
  for (let seed = 0; seed < 300; seed++) {
    // One percent is one cell: the first block is the last.
    const text = problemToText(
      make('blocks', { width: 10, height: 10 }, { density: 1, largest: 3 }, seed),
    )
    longest.add(Math.max(...text.split(/[.\nSG]+/).map((run) => run.length)))
  }
  expect([...longest].sort()).toEqual([0, 1, 2, 3])
})
