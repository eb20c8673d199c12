import { DX, DY, isDiagonal, stepOffsets } from '../grid/directions'
import { type Cell, isInside, pointOf } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'
import { obstaclesAround } from '../grid/steps'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { costParam } from './costs'
import { offlinePlanner } from './planner'
import { edgeTo, type Roadmap, roadmapPhases, roadmapPseudocode, searchRoadmap } from './roadmap'
import { searchParam } from './search-param'

const { text, line } = roadmapPseudocode({
  vertices: 'each free cell diagonal to an obstacle, both cells between them free',
  none: 'no path exists',
})

export const visibilityGraph = offlinePlanner({
  id: 'visibility-graph',
  title: 'Visibility graph',
  summary:
    'The corners of obstacles are joined wherever the simplest path between them is free; Dijkstra or A* searches that graph.',
  promise:
    'Complete: it proves it if no path exists. Optimal with only-when-no-obstacles and cost cells; with the report’s rule on about 4 of 5 random maps, because a path may cut a corner that the graph’s vertices go around.',
  complete: () => true,
  optimal: ({ cost }, diagonal) => cost === 'cells' && diagonal === 'only-when-no-obstacles',
  params: [searchParam, costParam],
  phases: roadmapPhases,
  pseudocode: text,
  source:
    'Report, IV.B; T. Lozano-Pérez and M. A. Wesley, "An algorithm for planning collision-free paths among polyhedral obstacles", 1979',

  plan(problem, { params, tape, progress }) {
    const failure = {
      status: 'unreachable',
      reason: 'the visibility graph does not join start and goal',
    } as const
    const { cost, search } = params
    const task = { problem, cost, search, failure, lines: line, tape, progress }
    tape?.at(line.vertices).write(EVENT.phase, -1, 0)
    return searchRoadmap(visibilityRoadmap(problem, tape), task)
  },
})

/** The cells that are vertices: start, goal, and the free corners of obstacles (Fig. 4). */
function findVertices({ grid, start, goal }: Problem, tape: Tape | undefined): Int32Array {
  const offsets = stepOffsets(grid.width)
  const isVertex = new Uint8Array(grid.walls.length)
  const vertices: Cell[] = []
  const add = (cell: Cell) => {
    if (isVertex[cell]) return
    isVertex[cell] = 1
    vertices.push(cell)
    tape?.write(EVENT.vertex, cell)
  }
  add(start)
  add(goal)
  for (let obstacle = 0; obstacle < grid.walls.length; obstacle++) {
    if (!grid.walls[obstacle]) continue
    const around = obstaclesAround(grid, obstacle)
    const { x, y } = pointOf(grid.width, obstacle)
    for (let d = 1; d < 8; d += 2) {
      const isCorner = (around & CORNER[d]) === 0
      const cell = obstacle + offsets[d]
      if (tape && isInside(grid, x + DX[d], y + DY[d])) {
        tape.write(EVENT.test, cell, obstacle, isCorner ? 1 : 0)
      }
      if (isCorner) add(cell)
    }
  }
  return Int32Array.from(vertices)
}

/** For each diagonal direction the three directions whose cells must be free around a corner. */
const CORNER = Uint8Array.from({ length: 8 }, (_, d) =>
  isDiagonal(d) ? (1 << (d - 1)) | (1 << d) | (1 << ((d + 1) & 7)) : 0,
)

/**
 * The visibility graph, whose edges are found by looking: all cells with a free simplest path from
 * or to a vertex lie on rays that bend once, so walking these rays finds its neighbours in time
 * that grows with what it sees, not with the number of vertices.
 */
function visibilityRoadmap(problem: Problem, tape: Tape | undefined): Roadmap {
  const { grid, diagonal } = problem
  const legal = allLegalSteps(grid, diagonal)
  const offsets = stepOffsets(grid.width)
  const vertices = findVertices(problem, tape)
  /** For each cell the place of its vertex, counted from 1; 0 if it is none. */
  const places = new Int32Array(grid.walls.length)
  for (let i = 0; i < vertices.length; i++) places[vertices[i]] = i + 1

  const edgesOf = (vertex: number, edges: Int32Array): number => {
    let count = 0
    for (let d = 0; d < 8; d++) {
      // A simplest path begins with its diagonal part: after a straight ray it is walked backwards.
      const outward = (d & 1) as 0 | 1
      const offset = offsets[d]
      for (let bend = vertices[vertex]; (legal[bend] >> d) & 1; ) {
        bend += offset
        if (places[bend] > 0) edges[count++] = edgeTo(places[bend] - 1, 1)
        for (let turn = -1; turn <= 1; turn += 2) {
          const second = (d + turn) & 7
          const onward = offsets[second]
          for (let cell = bend; (legal[cell] >> second) & 1; ) {
            cell += onward
            if (places[cell] > 0) edges[count++] = edgeTo(places[cell] - 1, outward)
          }
        }
      }
    }
    return count
  }
  return { vertices, edgesOf }
}
