import { expect, test } from 'vitest'
import { acrossAll, generatedMap, MAP_KINDS, WIDE_KINDS } from '../../bench/planners/maps'
import { leastCost } from '../../bench/planners/plain/dijkstra'
import { Flood } from '../../bench/planners/plain/flood'
import { Heap } from '../../bench/planners/plain/heap'
import { walkIsFree, walkPairs } from '../../bench/planners/plain/pairs'
import { leastOverEdges } from '../../bench/planners/plain/roadmap'
import { costOfPath } from '../../bench/planners/plain/steps'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { simplestPath } from '../../src/grid/simplest-path'
import { problemFromText } from '../../src/index'
import { mapNumber } from '../reference/maps'
import { shortestWay } from '../reference/shortest'
import { flood, problemOf } from '../reference/world'

const RULE = 'only-when-no-obstacles'

test('the heap gives its items by their keys', () => {
  const random = randomNumbers(1)
  const keys = Array.from({ length: 500 }, () => randomInteger(random, 100))
  const heap = new Heap()
  for (const key of keys) heap.push(-key, key)
  const popped = keys.map(() => heap.pop())
  expect(popped).toEqual(keys.sort((a, b) => a - b).map((key) => -key))
  expect(heap.pop()).toBeUndefined()
})

test('the plain Dijkstra agrees with brute force, by both costs', () => {
  for (let i = 0; i < 150; i++) {
    const world = mapNumber(3, i, RULE)
    const { grid, start, goal } = problemOf(world)
    for (const cost of ['cells', 'euclidean'] as const) {
      const way = shortestWay(world, cost)
      const expected = way
        ? way.steps + (cost === 'cells' ? 0 : way.diagonals * (Math.SQRT2 - 1))
        : Number.POSITIVE_INFINITY
      const least = leastCost(grid, { start, goal }, cost === 'cells' ? 1 : Math.SQRT2)
      if (way) expect(least).toBeCloseTo(expected, 9)
      else expect(least).toBe(expected)
    }
  }
})

test('the flood comes to all cells that straight steps lead to, again and again', () => {
  for (let i = 0; i < 100; i++) {
    const world = mapNumber(4, i, RULE)
    const { grid, start, goal } = problemOf(world)
    const plain = new Flood(grid)
    for (const from of [start, goal]) {
      const count = plain.run(from)
      const names = Array.from(plain.reached(count), (cell) => {
        return `${cell % grid.width},${Math.floor(cell / grid.width)}`
      })
      const [x, y] = [from % grid.width, Math.floor(from / grid.width)]
      expect(new Set(names)).toEqual(new Set(flood({ ...world, start: [x, y] })))
      expect(names.length).toBe(new Set(names).size)
      expect(names[0]).toBe(`${x},${y}`)
    }
  }
})

test('a walk is free where each step of the simplest path is legal', () => {
  const { grid, queries } = generatedMap('random', { width: 30, height: 20 }, 5, 1)
  const free = Array.from(grid.walls.keys()).filter((cell) => !grid.walls[cell])
  const random = randomNumbers(2)
  const seen = { free: 0, refused: 0 }
  for (let i = 0; i < 3000; i++) {
    const [from, to] = [free[randomInteger(random, free.length)], queries[0].goal]
    const path = simplestPath(grid.width, from, to)
    const isFree = !Number.isNaN(costOfPath(grid, { start: from, goal: to }, path, 1))
    expect(walkIsFree(grid, from, to)).toBe(isFree)
    seen[isFree ? 'free' : 'refused']++
  }
  expect(Math.min(seen.free, seen.refused)).toBeGreaterThan(10)
})

test('of the vertices every so many is joined with those after it', () => {
  const { grid } = generatedMap('open', { width: 30, height: 20 }, 1, 1)
  const vertices = Array.from({ length: 100 }, (_, i) => 5 * i)
  const walked = (every: number) => {
    const pairs = new Set<string>()
    const part = walkPairs(grid, vertices, every, (a, b) => pairs.add(`${a} ${b}`))
    expect(part).toBeCloseTo(pairs.size / 4950, 12)
    return pairs.size
  }
  expect(walked(1)).toBe(4950)
  // Vertices 0, 10 … 90 with the 99, 89 … 9 after them.
  expect(walked(10)).toBe(540)
})

test('a path is told by its cost, and what is no path by NaN', () => {
  const { grid, start, goal } = problemFromText('S..\n.#.\n..G')
  const cost = (path: number[]) => costOfPath(grid, { start, goal }, path, Math.SQRT2)
  expect(cost([0, 1, 2, 5, 8])).toBe(4)
  expect(cost([0, 1, 5, 8])).toBeNaN()
  expect(cost([0, 4, 8])).toBeNaN()
  expect(cost([0, 2, 5, 8])).toBeNaN()
  expect(cost([1, 2, 5, 8])).toBeNaN()
  expect(cost([0, 1, 2, 5])).toBeNaN()
  expect(cost([])).toBeNaN()
  const open = { ...grid, walls: new Uint8Array(9) }
  expect(costOfPath(open, { start, goal }, [0, 4, 8], Math.SQRT2)).toBeCloseTo(2 * Math.SQRT2, 12)
  expect(costOfPath(open, { start, goal }, [0, 4, 8], 1)).toBe(2)
})

test('the way over edges is as long as their simplest paths', () => {
  const edges = [
    [0, 3],
    [3, 33],
    [0, 55],
  ] as const
  expect(leastOverEdges(10, edges, 0, 33)).toBeCloseTo(6, 12)
  expect(leastOverEdges(10, edges, 55, 0)).toBeCloseTo(5 * Math.SQRT2, 12)
  expect(leastOverEdges(10, edges, 0, 99)).toBe(Number.POSITIVE_INFINITY)
})

test.each([...MAP_KINDS, ...WIDE_KINDS])(
  'starts and goals on %s maps are far apart and joined',
  (kind) => {
    const size = { width: 60, height: 40 }
    const map = generatedMap(kind, size, 3, 5)
    expect(generatedMap(kind, size, 3, 5)).toEqual(map)
    for (const { start, goal } of map.queries) {
      const apart = Math.max(
        Math.abs((start % 60) - (goal % 60)),
        Math.abs(Math.floor(start / 60) - Math.floor(goal / 60)),
      )
      expect(apart).toBeGreaterThanOrEqual(45)
      expect(leastCost(map.grid, { start, goal }, 1)).toBeLessThan(Number.POSITIVE_INFINITY)
    }
    const { start } = map.queries[0]
    const across = acrossAll(map.grid, start)
    const fromEnd = new Flood(map.grid)
    const count = fromEnd.run(across.start)
    expect(fromEnd.reached(count).at(-1)).toBe(across.goal)
  },
)
