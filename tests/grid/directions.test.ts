import { expect, test } from 'vitest'
import { DX, DY, directionOf, isDiagonal, opposite, stepOffsets } from '../../src/grid/directions'

/** By name, in the order of the directions. */
const COMPASS = {
  N: [0, -1],
  NE: [1, -1],
  E: [1, 0],
  SE: [1, 1],
  S: [0, 1],
  SW: [-1, 1],
  W: [-1, 0],
  NW: [-1, -1],
} as const

test('a direction is what its name says', () => {
  expect([DX.length, DY.length]).toEqual([8, 8])
  Object.entries(COMPASS).forEach(([name, [dx, dy]], d) => {
    expect([DX[d], DY[d]], name).toEqual([dx, dy])
    expect(isDiagonal(d), name).toBe(name.length === 2)
    expect([DX[opposite(d)] + dx, DY[opposite(d)] + dy], name).toEqual([0, 0])
    expect(stepOffsets(10)[d], name).toBe(dx + 10 * dy)
  })
})

test('any pair of numbers points where both signs point', () => {
  for (let dx = -3; dx <= 3; dx++) {
    for (let dy = -3; dy <= 3; dy++) {
      const north = dy < 0 ? 'N' : dy > 0 ? 'S' : ''
      const east = dx < 0 ? 'W' : dx > 0 ? 'E' : ''
      const d = Object.keys(COMPASS).indexOf(north + east)
      expect(directionOf(dx, dy), `(${dx}, ${dy})`).toBe(d)
    }
  }
})
