import fc from 'fast-check'
import { generators } from '../../../src/grid/generators'
import type { Generator } from '../../../src/grid/generators/generator'
import type { Size } from '../../../src/grid/grid'
import type { Problem } from '../../../src/index'

export const sizes = fc.record({
  width: fc.integer({ min: 2, max: 30 }),
  height: fc.integer({ min: 2, max: 30 }),
})

export const seeds = fc.maxSafeInteger()

export function byId(id: string): Generator {
  const found = generators.find((generator) => generator.id === id)
  if (!found) throw new Error(`no generator ${id}`)
  return found
}

export const make = (id: string, size: Size, params: Record<string, number>, seed: number) =>
  byId(id).generate(size, params, seed, 'if-at-most-one-obstacle')

/** Pairs of free cells that touch by a side. */
export function freePairs({ grid: { width, walls } }: Problem): [number, number][] {
  const pairs: [number, number][] = []
  walls.forEach((wall, cell) => {
    if (wall) return
    if (cell % width < width - 1 && !walls[cell + 1]) pairs.push([cell, cell + 1])
    if (cell + width < walls.length && !walls[cell + width]) pairs.push([cell, cell + width])
  })
  return pairs
}

export const freeCount = ({ grid }: Problem): number => grid.walls.filter((wall) => !wall).length

/** How many pieces the free cells fall into, by steps across sides only: a union of sets. */
export function pieces(problem: Problem): number {
  const parent = Int32Array.from(problem.grid.walls, (_, cell) => cell)
  const root = (cell: number): number => {
    let at = cell
    while (parent[at] !== at) at = parent[at]
    return at
  }
  let count = freeCount(problem)
  for (const [a, b] of freePairs(problem)) {
    if (root(a) === root(b)) continue
    parent[root(a)] = root(b)
    count--
  }
  return count
}
