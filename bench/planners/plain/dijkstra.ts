import type { Grid } from '../../../src/grid/grid'
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
    const x = cell % width
    const y = (cell - x) / width
    for (let nextY = y - 1; nextY <= y + 1; nextY++) {
      for (let nextX = x - 1; nextX <= x + 1; nextX++) {
        if (!isLegalStep(grid, x, y, nextX, nextY)) continue
        const next = nextY * width + nextX
        const cost = costs[cell] + (nextX !== x && nextY !== y ? diagonal : 1)
        if (cost >= costs[next]) continue
        costs[next] = cost
        open.push(next, cost)
      }
    }
  }
  return Number.POSITIVE_INFINITY
}
