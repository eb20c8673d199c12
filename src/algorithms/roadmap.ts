import FlatQueue from 'flatqueue'
import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { simplestPath } from '../grid/simplest-path'
import { EVENT, type Status } from '../trace/events'
import type { Tape } from '../trace/tape'
import { type Cost, costOfWeight, weightsTo } from './costs'
import { memoryFor } from './grid-search/memory'
import type { Answer } from './planner'
import { pseudocode } from './pseudocode'
import { recordEdges } from './roadmap-edges'
import type { Search } from './search-param'
import { Sight } from './sight/sight'

/** A graph over some of the map's free cells, joined where a simplest path between them is free. */
export interface Roadmap {
  /** The cells that are vertices, each once, start and goal among them. */
  readonly vertices: Int32Array
  /** For each cell of the map 1 if it is one of them. */
  readonly isVertex: Uint8Array
}

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
export const roadmapVariables = ['least cost of a path over this vertex'] as const

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

/** States of a vertex, 0 before it is reached; with `OUTWARD` if the simplest path to it is the free one. */
const OPEN = 2
const CLOSED = 4
const OUTWARD = 1

/**
 * Dijkstra or A* over a roadmap. An edge weighs what its simplest path weighs. Edges are found as
 * the search needs them; only a tape has all of them recorded first, as the report's method does it.
 *
 * A* adds the weight of the simplest path to the goal, whatever is in the way. No edge weighs less
 * than what it takes off that (a simplest path is a shortest one), so a closed vertex is final, and
 * all that A* closes has less weight than the goal, so that Dijkstra closes it too.
 */
export function searchRoadmap(roadmap: Roadmap, task: Task): Answer {
  const { problem, cost, search, failure, lines, tape, progress } = task
  const { grid, start, goal } = problem
  const { vertices, isVertex } = roadmap
  const sight = new Sight(problem, isVertex, cost)
  const recording = tape ? 0.5 : 0
  if (tape) {
    const share = (done: number) => progress(recording * done)
    recordEdges(vertices, sight, problem, cost, tape.at(lines.edges), share)
  }
  tape?.at(lines.open).write(EVENT.phase, -1, 2)
  const isStarred = search === 'a-star'
  const estimate = weightsTo(goal, cost, grid.width)
  const { edges } = sight
  const { states, weights, buckets } = memoryFor(grid.walls.length)
  const parents = new Int32Array(grid.walls.length)
  // Vertices straight on the way to the goal: of least weight already, they need not queue.
  const [next] = buckets
  const queue = new FlatQueue<Cell>()
  let here = start
  let soFar = 0
  let least = isStarred ? estimate(start) : 0
  let expanded = 0

  states.fill(0, 0, grid.walls.length)
  states[start] = OPEN
  weights[start] = 0
  parents[start] = -1
  next.push(start)
  tape?.write(EVENT.open, start)
  if (isStarred) tape?.write(EVENT.estimate, goal, 0)
  for (;;) {
    if (next.count === 0) {
      least = queue.peekValue() ?? least
      const first = queue.pop()
      if (first === undefined) break
      next.push(first)
    }
    here = next.cells[--next.count]
    // A vertex that was improved waits in a later place too.
    if (states[here] & CLOSED) continue
    states[here] |= CLOSED
    soFar = weights[here]
    tape?.at(lines.close).write(EVENT.close, here, -1, costOfWeight(cost, soFar))
    if (++expanded % 256 === 0) {
      progress(recording + ((1 - recording) * expanded) / vertices.length)
    }
    if (here === goal) {
      const path = joinCells(grid.width, goal, parents, states)
      tape?.at(lines.found).write(EVENT.phase, -1, 3)
      if (tape) for (const cell of path) tape.write(EVENT.path, cell)
      return { status: 'reached', reason: 'the shortest path on the roadmap', path, expanded }
    }
    const count = sight.nearest(here)
    for (let i = 0; i < count; i++) {
      const vertex = edges.ends[i]
      const known = states[vertex]
      const weight = soFar + edges.weights[i]
      if (known & CLOSED || (known !== 0 && weight >= weights[vertex])) continue
      states[vertex] = OPEN | edges.outwards[i]
      weights[vertex] = weight
      parents[vertex] = here
      const whole = isStarred ? weight + estimate(vertex) : weight
      if (whole === least) next.push(vertex)
      else queue.push(vertex, whole)
      if (tape) tape.at(lines.open).write(EVENT.open, vertex, here, costOfWeight(cost, weight))
    }
  }
  tape?.at(lines.none)
  return { ...failure, path: new Int32Array(0), expanded }
}

/** The cells from the start to the goal: the simplest paths of the edges, one after the other. */
function joinCells(
  width: number,
  goal: Cell,
  parents: Int32Array,
  states: Uint16Array,
): Int32Array {
  const backwards: Cell[] = [goal]
  for (let vertex = goal; parents[vertex] >= 0; vertex = parents[vertex]) {
    const parent = parents[vertex]
    const cells =
      states[vertex] & OUTWARD
        ? simplestPath(width, parent, vertex).reverse()
        : simplestPath(width, vertex, parent)
    for (const cell of cells.subarray(1)) backwards.push(cell)
  }
  return Int32Array.from(backwards.reverse())
}
