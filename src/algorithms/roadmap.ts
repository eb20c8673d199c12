import FlatQueue from 'flatqueue'
import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { simplestPath } from '../grid/simplest-path'
import { EVENT, type Status } from '../trace/events'
import type { Tape } from '../trace/tape'
import { type Cost, costOfWeight, simplestPathWeights } from './costs'
import type { Answer } from './planner'
import { pseudocode } from './pseudocode'
import { recordEdges } from './roadmap-edges'
import type { Search } from './search-param'

/** A graph over some of the map's free cells, joined where a simplest path between them is free. */
export interface Roadmap {
  /** The cells that are vertices, each once, start and goal among them. */
  readonly vertices: Int32Array
  /**
   * Writes the edges of a vertex, named by its place in `vertices`, into the array and returns
   * their number. Each is an `edgeTo`; a vertex may stand there twice, once for each way round.
   */
  edgesOf(vertex: number, edges: Int32Array): number
}

/**
 * An edge to the vertex `other`. `outward` tells which simplest path is known to be free: the one
 * to that vertex (1), or else the one back from it (0).
 */
export const edgeTo = (other: number, outward: 0 | 1): number => (other << 1) | outward
export const otherEnd = (edge: number): number => edge >> 1
export const isOutward = (edge: number): boolean => (edge & 1) === 1

/** Room for all that `edgesOf` may write. */
export const roomForEdges = ({ vertices }: Roadmap): Int32Array =>
  new Int32Array(2 * vertices.length)

type RoadmapLines = ReturnType<typeof roadmapPseudocode>['line']

/** The pseudocode of a roadmap planner: they differ in their vertices and in what failure means. */
export function roadmapPseudocode(own: { readonly vertices: string; readonly none: string }) {
  return pseudocode({
    vertices: `vertices ← start, goal, and ${own.vertices}`,
    edges: 'for each pair of vertices: an edge if a simplest path between them is free',
    open: 'put the start, then each vertex that gets a shorter way, among the open ones',
    close:
      'take the open vertex with the least cost (a-star: plus that of its simplest path to the goal) and close it: its way is final',
    found: 'if it is the goal: join the simplest paths from the start to it',
    none: `if no vertex is open: ${own.none}`,
  })
}

export const roadmapPhases = ['Find the vertices', 'Try simplest paths', 'Search', 'Path'] as const

interface Task {
  readonly problem: Problem
  readonly cost: Cost
  readonly search: Search
  /** What is said if the roadmap does not join start and goal. */
  readonly failure: { readonly status: Status; readonly reason: string }
  readonly lines: RoadmapLines
  readonly tape: Tape | undefined
  readonly progress: (done: number) => void
}

/**
 * Dijkstra or A* over a roadmap. An edge weighs what its simplest path costs. Edges are found as the
 * search needs them; only a tape has all of them recorded first, as the report's method does it.
 *
 * A* adds the cost of the simplest path to the goal, whatever is in the way. No edge weighs less
 * than what it takes off that (a simplest path is a shortest one), so a closed vertex is final, and
 * all that A* closes has less cost than the goal, so that Dijkstra closes it too.
 */
export function searchRoadmap(roadmap: Roadmap, task: Task): Answer {
  const { problem, cost, search, failure, lines, tape, progress } = task
  const { vertices } = roadmap
  const { width } = problem.grid
  const recording = tape ? 0.5 : 0
  if (tape) {
    recordEdges(roadmap, problem, cost, tape.at(lines.edges), (done) => progress(recording * done))
  }
  tape?.at(lines.open).write(EVENT.phase, -1, 2)
  const weigh = simplestPathWeights(cost, width)
  const leftFrom = (cell: Cell) => (search === 'a-star' ? weigh(cell, problem.goal) : 0)
  const start = vertices.indexOf(problem.start)
  const goal = vertices.indexOf(problem.goal)
  const weights = new Float64Array(vertices.length).fill(Number.POSITIVE_INFINITY)
  const parents = new Int32Array(vertices.length).fill(-1)
  /** Whether the simplest path from the parent is the free one, or else the one to it. */
  const outwards = new Uint8Array(vertices.length)
  const closed = new Uint8Array(vertices.length)
  const edges = roomForEdges(roadmap)
  const queue = new FlatQueue<number>()
  weights[start] = 0
  queue.push(start, 0)
  tape?.write(EVENT.open, problem.start)
  let expanded = 0
  for (let vertex = queue.pop(); vertex !== undefined; vertex = queue.pop()) {
    if (closed[vertex]) continue
    closed[vertex] = 1
    tape
      ?.at(lines.close)
      .write(EVENT.close, vertices[vertex], -1, costOfWeight(cost, weights[vertex]))
    if (++expanded % 256 === 0) {
      progress(recording + ((1 - recording) * expanded) / vertices.length)
    }
    if (vertex === goal) {
      const path = joinCells(width, vertices, parents, outwards, goal)
      tape?.at(lines.found).write(EVENT.phase, -1, 3)
      for (const cell of path) tape?.write(EVENT.path, cell)
      return { status: 'reached', reason: 'the shortest path on the roadmap', path, expanded }
    }
    const count = roadmap.edgesOf(vertex, edges)
    for (let i = 0; i < count; i++) {
      const other = otherEnd(edges[i])
      if (closed[other]) continue
      const next = weights[vertex] + weigh(vertices[vertex], vertices[other])
      if (next >= weights[other]) continue
      weights[other] = next
      parents[other] = vertex
      outwards[other] = edges[i] & 1
      queue.push(other, next + leftFrom(vertices[other]))
      tape
        ?.at(lines.open)
        .write(EVENT.open, vertices[other], vertices[vertex], costOfWeight(cost, next))
    }
  }
  tape?.at(lines.none)
  return { ...failure, path: new Int32Array(0), expanded }
}

/** The cells from the start to the goal: the simplest paths of the edges, one after the other. */
function joinCells(
  width: number,
  vertices: Int32Array,
  parents: Int32Array,
  outwards: Uint8Array,
  goal: number,
): Int32Array {
  const backwards: Cell[] = [vertices[goal]]
  for (let vertex = goal; parents[vertex] >= 0; vertex = parents[vertex]) {
    const here = vertices[vertex]
    const parent = vertices[parents[vertex]]
    const cells = outwards[vertex]
      ? simplestPath(width, parent, here).reverse()
      : simplestPath(width, here, parent)
    for (const cell of cells.subarray(1)) backwards.push(cell)
  }
  return Int32Array.from(backwards.reverse())
}
