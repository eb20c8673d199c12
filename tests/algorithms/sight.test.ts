import fc from 'fast-check'
import { expect, test } from 'vitest'
import { ClearTable } from '../../src/algorithms/sight/clear-table'
import {
  type Edges,
  type Rays,
  raysOver,
  roomForEdges,
  type Seen,
} from '../../src/algorithms/sight/rays'
import { Sight } from '../../src/algorithms/sight/sight'
import { Walker } from '../../src/algorithms/sight/walker'
import { emptyGrid } from '../../src/grid/grid'
import { simplestPath } from '../../src/grid/simplest-path'
import type { Problem } from '../../src/index'
import { problems } from '../grid/arbitraries'

/** Each third free cell or so. */
function someVertices({ grid }: Problem): Uint8Array {
  return grid.walls.map((wall, cell) => (wall === 0 && (cell * 7) % 3 === 0 ? 1 : 0))
}

interface Finder {
  nearest(from: number): number
  all(from: number, seen: Seen): void
}

function found(Finder: new (rays: Rays, edges: Edges) => Finder, rays: Rays, side: number) {
  const edges = roomForEdges(side)
  const finder = new Finder(rays, edges)
  return Array.from(rays.marks.keys(), (from) => {
    const all: string[] = []
    finder.all(from, (vertex, outward) => all.push(`${vertex} ${outward}`))
    return [listed(edges, finder.nearest(from)), all]
  })
}

function listed({ ends, weights, outwards }: Edges, count: number): string[] {
  return Array.from({ length: count }, (_, i) => `${ends[i]} ${weights[i]} ${outwards[i]}`)
}

test('walking and looking up find the same edges in the same order', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      const rays = raysOver(problem, someVertices(problem), 'euclidean')
      const side = Math.max(problem.grid.width, problem.grid.height)
      expect(found(ClearTable, rays, side)).toEqual(found(Walker, rays, side))
    }),
  )
})

test('the nearest are those of all between which no vertex lies', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      const { width } = problem.grid
      const isVertex = someVertices(problem)
      const sight = new Sight(problem, isVertex, 'cells')
      for (const from of isVertex.keys()) {
        if (!isVertex[from]) continue
        const expected: string[] = []
        sight.all(from, (vertex, outward) => {
          const path = outward
            ? simplestPath(width, from, vertex)
            : simplestPath(width, vertex, from)
          if (path.subarray(1, -1).some((cell) => isVertex[cell])) return
          expected.push(`${vertex} ${outward}`)
        })
        const { ends, outwards } = sight.edges
        const nearest = Array.from({ length: sight.nearest(from) }, (_, i) => i)
        expect(nearest.map((i) => `${ends[i]} ${outwards[i]}`).sort()).toEqual(expected.sort())
      }
    }),
  )
})

test('after long walks the table answers, and the answer is the same', () => {
  const grid = emptyGrid(40, 40)
  const problem = { grid, start: 0, goal: 1, diagonal: 'if-at-most-one-obstacle' } as const
  const isVertex = new Uint8Array(1600)
  for (const cell of [0, 820, 1599]) isVertex[cell] = 1
  const sight = new Sight(problem, isVertex, 'euclidean')
  const first = listed(sight.edges, sight.nearest(820))
  const before = sight.isWalking
  for (let i = 0; i < 1000; i++) sight.nearest(820)
  expect([before, sight.isWalking]).toEqual([true, false])
  expect(listed(sight.edges, sight.nearest(820))).toEqual(first)
})
