import { expect, test } from 'vitest'
import {
  DIRECTION_NAMES,
  DX,
  DY,
  directionOf,
  isDiagonal,
  opposite,
  stepOffsets,
} from '../../src/grid/directions'

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
  expect(DIRECTION_NAMES).toEqual(Object.keys(COMPASS))
  DIRECTION_NAMES.forEach((name, d) => {
    const [dx, dy] = COMPASS[name]
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
      const names: readonly string[] = DIRECTION_NAMES
      expect(directionOf(dx, dy), `(${dx}, ${dy})`).toBe(names.indexOf(north + east))
    }
  }
})
