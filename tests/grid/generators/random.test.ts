import fc from 'fast-check'
import { expect, test } from 'vitest'
import { freeCount, make, seeds, sizes } from './maps'

test('the share of obstacles is the density', () => {
  for (const density of [1, 10, 25, 50, 90]) {
    const problem = make('random', { width: 300, height: 200 }, { density }, density)
    const share = 100 * (1 - freeCount(problem) / 60_000)
    // Four standard deviations of 60,000 throws are at most 0.82 %.
    expect(Math.abs(share - density), `${density} %`).toBeLessThan(0.85)
  }
})

test('at density 0 nothing is an obstacle', () => {
  fc.assert(
    fc.property(sizes, seeds, (size, seed) => {
      expect(freeCount(make('random', size, { density: 0 }, seed))).toBe(size.width * size.height)
    }),
  )
})

test('obstacles lie everywhere, in the corners too', () => {
  const size = { width: 5, height: 5 }
  const seen = new Uint8Array(25)
  for (let seed = 0; seed < 200; seed++) {
    make('random', size, { density: 50 }, seed).grid.walls.forEach((wall, cell) => {
      seen[cell] |= wall
    })
  }
  const { start, goal } = make('random', size, { density: 50 }, 0)
  const never = Array.from(seen.keys()).filter((cell) => !seen[cell])
  expect(never).toEqual([start, goal])
})
