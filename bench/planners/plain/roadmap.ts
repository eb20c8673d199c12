import type { Cell, Grid } from '../../../src/grid/grid'
import { Heap } from './heap'
import { walkPairs } from './pairs'

/** Two cells joined by a free simplest path. */
export type Edge = readonly [Cell, Cell]

/** All edges between some cells, by walking each pair. */
export function edgesAmong(grid: Grid, cells: ArrayLike<Cell>): Edge[] {
  const edges: Edge[] = []
  walkPairs(grid, cells, 1, (a, b) => edges.push([a, b]))
  return edges
}

/** Euclidean length of the shortest way along edges, each as long as its simplest path. */
export function leastOverEdges(
  width: number,
  edges: readonly Edge[],
  start: Cell,
  goal: Cell,
): number {
  const around = new Map<Cell, Cell[]>()
  const join = (from: Cell, to: Cell) => {
    const others = around.get(from) ?? []
    others.push(to)
    around.set(from, others)
  }
  for (const [a, b] of edges) {
    join(a, b)
    join(b, a)
  }
  const lengths = new Map<Cell, number>([[start, 0]])
  const open = new Heap()
  open.push(start, 0)
  for (let cell = open.pop(); cell !== undefined; cell = open.pop()) {
    const here = lengths.get(cell) ?? 0
    if (cell === goal) return here
    for (const next of around.get(cell) ?? []) {
      const length = here + octile(width, cell, next)
      if (length >= (lengths.get(next) ?? Number.POSITIVE_INFINITY)) continue
      lengths.set(next, length)
      open.push(next, length)
    }
  }
  return Number.POSITIVE_INFINITY
}

function octile(width: number, a: Cell, b: Cell): number {
  const dx = Math.abs((a % width) - (b % width))
  const dy = Math.abs(Math.floor(a / width) - Math.floor(b / width))
  return Math.max(dx, dy) + (Math.SQRT2 - 1) * Math.min(dx, dy)
}
