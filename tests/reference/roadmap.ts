import { type CostName, isShorter, type Way } from './shortest'
import { freeCells, isFree, isSame, isWall, simplest, type World, type XY } from './world'

/** Start, goal, and the free cells diagonal to an obstacle cell with both cells between them free. */
export function obstacleVertices(world: World): XY[] {
  const isCorner = ([x, y]: XY) =>
    [-1, 1].some((dx) =>
      [-1, 1].some(
        (dy) =>
          isInsideWall(world, x + dx, y + dy) &&
          !isWall(world, x + dx, y) &&
          !isWall(world, x, y + dy),
      ),
    )
  return freeCells(world).filter(
    (cell) => isSame(cell, world.start) || isSame(cell, world.goal) || isCorner(cell),
  )
}

/** An obstacle cell of the map itself: the border has no vertices. */
function isInsideWall(world: World, x: number, y: number): boolean {
  return x >= 0 && y >= 0 && x < world.width && y < world.height && isWall(world, x, y)
}

export interface Edge {
  readonly from: number
  readonly to: number
  readonly way: Way
}

/** All pairs with a free simplest path in at least one direction; numbers are places in `vertices`. */
export function allEdges(world: World, vertices: readonly XY[]): Edge[] {
  const edges: Edge[] = []
  for (let from = 0; from < vertices.length; from++) {
    for (let to = from + 1; to < vertices.length; to++) {
      const a = vertices[from]
      const b = vertices[to]
      if (!isFree(world, simplest(a, b)) && !isFree(world, simplest(b, a))) continue
      const dx = Math.abs(a[0] - b[0])
      const dy = Math.abs(a[1] - b[1])
      edges.push({ from, to, way: { steps: Math.max(dx, dy), diagonals: Math.min(dx, dy) } })
    }
  }
  return edges
}

/** Dijkstra with a scan for the nearest open vertex; undefined if there is no way. */
export function shortestOnRoadmap(
  count: number,
  edges: readonly Edge[],
  start: number,
  goal: number,
  cost: CostName,
): Way | undefined {
  const beside: { to: number; way: Way }[][] = Array.from({ length: count }, () => [])
  for (const { from, to, way } of edges) {
    beside[from].push({ to, way })
    beside[to].push({ to: from, way })
  }
  const best = new Map<number, Way>([[start, { steps: 0, diagonals: 0 }]])
  const closed = new Set<number>()
  for (;;) {
    let nearest = -1
    let here: Way | undefined
    for (const [vertex, way] of best) {
      if (closed.has(vertex) || (here && !isShorter(way, here, cost))) continue
      nearest = vertex
      here = way
    }
    if (!here) return undefined
    if (nearest === goal) return here
    closed.add(nearest)
    for (const { to, way } of beside[nearest]) {
      const longer = {
        steps: here.steps + way.steps,
        diagonals: here.diagonals + way.diagonals,
      }
      const before = best.get(to)
      if (!before || isShorter(longer, before, cost)) best.set(to, longer)
    }
  }
}
