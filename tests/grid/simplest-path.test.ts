import fc from 'fast-check'
import { expect, test } from 'vitest'
import {
  distance,
  euclideanDistance,
  farness,
  indexOnSimplestPath,
  simplestPath,
} from '../../src/grid/simplest-path'
import { places } from './arbitraries'

interface XY {
  x: number
  y: number
}

/** Diagonal while both axes differ, then straight: said once more, with points. */
function walk(from: XY, to: XY): XY[] {
  const way = [from]
  let { x, y } = from
  while (x !== to.x || y !== to.y) {
    if (x < to.x) x++
    else if (x > to.x) x--
    if (y < to.y) y++
    else if (y > to.y) y--
    way.push({ x, y })
  }
  return way
}

const WIDTH = 40
const cell = ({ x, y }: XY): number => y * WIDTH + x

test('the simplest path', () => {
  fc.assert(
    fc.property(places, places, (a, b) => {
      expect(Array.from(simplestPath(WIDTH, cell(a), cell(b)))).toEqual(walk(a, b).map(cell))
    }),
  )
})

test('the distance is its number of steps', () => {
  fc.assert(
    fc.property(places, places, (a, b) => {
      expect(distance(a, b)).toBe(walk(a, b).length - 1)
    }),
  )
})

test('a cell knows its place on the path, and the cells off the path that they are off it', () => {
  fc.assert(
    fc.property(places, places, places, (a, b, other) => {
      const way = walk(a, b)
      way.forEach((point, i) => {
        expect(indexOnSimplestPath(a, b, point)).toBe(i)
      })
      const found = way.findIndex(({ x, y }) => x === other.x && y === other.y)
      expect(indexOnSimplestPath(a, b, other)).toBe(found)
    }),
  )
})

test('farness orders places by distance and equal ones by Euclidean distance', () => {
  fc.assert(
    fc.property(places, places, places, (a, b, to) => {
      const order =
        Math.sign(distance(a, to) - distance(b, to)) ||
        Math.sign((a.x - to.x) ** 2 + (a.y - to.y) ** 2 - (b.x - to.x) ** 2 - (b.y - to.y) ** 2)
      expect(Math.sign(farness(a, to) - farness(b, to))).toBe(order)
    }),
  )
})

test('farness is exact from corner to corner of the largest map', () => {
  const to = { x: 0, y: 0 }
  const far = farness({ x: 2047, y: 2047 }, to)
  expect(Number.isSafeInteger(far)).toBe(true)
  expect(far).toBeGreaterThan(farness({ x: 2047, y: 2046 }, to))
  expect(farness({ x: 2047, y: 0 }, to)).toBeGreaterThan(farness({ x: 2046, y: 2046 }, to))
})

test('Euclidean distance is the nearest number to the root, as on every machine', () => {
  const zero = { x: 0, y: 0 }
  expect(euclideanDistance({ x: 1, y: 2 }, { x: 4, y: -2 })).toBe(5)
  for (let x = 0; x < 60; x++) {
    for (let y = 0; y < 60; y++) {
      expect(euclideanDistance({ x, y }, zero)).toBe(Math.sqrt(x * x + y * y))
    }
  }
})
