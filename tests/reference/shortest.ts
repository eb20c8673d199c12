import { isWall, legalNeighbours, type World, type XY } from './world'

/** Length of a way as it is told apart: steps and, among them, diagonal ones. */
export interface Way {
  readonly steps: number
  readonly diagonals: number
}

export type CostName = 'cells' | 'euclidean'

export const lengthOf = ({ steps, diagonals }: Way): number =>
  steps - diagonals + diagonals * Math.SQRT2

export function isShorter(a: Way, b: Way, cost: CostName): boolean {
  if (cost === 'cells') {
    return a.steps < b.steps || (a.steps === b.steps && a.diagonals < b.diagonals)
  }
  return lengthOf(a) < lengthOf(b) - 1e-9
}

const NO_WAY: Way = { steps: Number.POSITIVE_INFINITY, diagonals: 0 }

/**
 * The shortest way from start to goal by relaxing every step of the map until nothing improves;
 * undefined if there is none. With `cells`, the one of least Euclidean length among the shortest.
 */
export function shortestWay(world: World, cost: CostName): Way | undefined {
  const { width, height } = world
  const best: Way[][] = Array.from({ length: height }, () => Array<Way>(width).fill(NO_WAY))
  const neighbours: XY[][][] = Array.from({ length: height }, (_, y) =>
    Array.from({ length: width }, (_, x) =>
      isWall(world, x, y) ? [] : legalNeighbours(world, [x, y]),
    ),
  )
  best[world.start[1]][world.start[0]] = { steps: 0, diagonals: 0 }
  let improved = true
  const relaxFrom = (x: number, y: number) => {
    const here = best[y][x]
    if (here === NO_WAY) return
    for (const [nx, ny] of neighbours[y][x]) {
      const diagonal = nx !== x && ny !== y ? 1 : 0
      const way = { steps: here.steps + 1, diagonals: here.diagonals + diagonal }
      if (!isShorter(way, best[ny][nx], cost)) continue
      best[ny][nx] = way
      improved = true
    }
  }
  while (improved) {
    improved = false
    // There and back, so that long ways settle in few rounds.
    for (let i = 0; i < width * height; i++) relaxFrom(i % width, Math.floor(i / width))
    for (let i = width * height - 1; i >= 0; i--) relaxFrom(i % width, Math.floor(i / width))
  }
  const way = best[world.goal[1]][world.goal[0]]
  return way === NO_WAY ? undefined : way
}
