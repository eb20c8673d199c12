import type { Grid } from '../../src/grid/grid'
import type { Query } from '../maps'
import { Heap } from './heap'
import { isLegalStep } from './steps'

/**
 * Cost of a shortest path under `only-when-no-obstacles`, straight steps at 1 and diagonal ones at
 * `diagonal`; Infinity if there is no path. Dijkstra with a heap, as plain as it gets: the truth
 * that decides who is wrong.
 */
export function leastCost(grid: Grid, { start, goal }: Query, diagonal: number): number {
  const { width, walls } = grid
  const costs = new Float64Array(walls.length).fill(Number.POSITIVE_INFINITY)
  const closed = new Uint8Array(walls.length)
  const open = new Heap()
  costs[start] = 0
  open.push(start, 0)
  for (let cell = open.pop(); cell !== undefined; cell = open.pop()) {
    if (cell === goal) return costs[goal]
    if (closed[cell]) continue
    closed[cell] = 1
    for (let dy = -1; dy <= 1; dy++) {
      for (let dx = -1; dx <= 1; dx++) {
        const next = cell + dy * width + dx
        const cost = costs[cell] + (dx !== 0 && dy !== 0 ? diagonal : 1)
        if (!(cost < costs[next]) || !isLegalStep(grid, cell, next)) continue
        costs[next] = cost
        open.push(next, cost)
      }
    }
  }
  return Number.POSITIVE_INFINITY
}
