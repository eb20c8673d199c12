import { type Direction, isDiagonal, stepOffsets, stepped } from '../grid/directions'
import { type Cell, type Grid, isInside, isObstacle, pointOf } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { allLegalSteps } from '../grid/steps'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { costParam } from './costs'
import { offlinePlanner } from './planner'
import {
  type Roadmap,
  roadmapPhases,
  roadmapPseudocode,
  searchRoadmap,
  type VisitNeighbour,
} from './roadmap'

const { text, line } = roadmapPseudocode({
  vertices: 'each free cell diagonal to an obstacle, both cells between them free',
  none: 'no path exists',
})

export const visibilityGraph = offlinePlanner({
  id: 'visibility-graph',
  title: 'Visibility graph',
  summary:
    'The corners of obstacles are joined wherever the simplest path between them is free; Dijkstra searches that graph.',
  promise:
    'Complete: it proves it if no path exists. Optimal with only-when-no-obstacles and cost cells; with the report’s rule on about 4 of 5 random maps, because a path may cut a corner that the graph’s vertices go around.',
  complete: () => true,
  optimal: ({ cost }, diagonal) => cost === 'cells' && diagonal === 'only-when-no-obstacles',
  params: [costParam],
  phases: roadmapPhases,
  pseudocode: text,
  source:
    'Report, IV.B; T. Lozano-Pérez and M. A. Wesley, "An algorithm for planning collision-free paths among polyhedral obstacles", 1979',

  plan(problem, { params, tape, progress }) {
    const failure = {
      status: 'unreachable',
      reason: 'the visibility graph does not join start and goal',
    } as const
    const { cost } = params
    const task = { problem, cost, failure, lines: line, tape, progress }
    tape?.at(line.vertices).write(EVENT.phase, -1, 0)
    return searchRoadmap(visibilityRoadmap(problem, tape), task)
  },
})

/** For each cell whether it is a vertex: start, goal, or the free corner of an obstacle (Fig. 4). */
function markVertices({ grid, start, goal }: Problem, tape: Tape | undefined): Uint8Array {
  const isVertex = new Uint8Array(grid.walls.length)
  const mark = (cell: Cell) => {
    if (isVertex[cell]) return
    isVertex[cell] = 1
    tape?.write(EVENT.vertex, cell)
  }
  mark(start)
  mark(goal)
  for (let obstacle = 0; obstacle < grid.walls.length; obstacle++) {
    if (!grid.walls[obstacle]) continue
    for (let d = 1; d < 8; d += 2) {
      const corner = stepped(pointOf(grid.width, obstacle), d)
      if (!isInside(grid, corner.x, corner.y)) continue
      const cell = corner.y * grid.width + corner.x
      const isCorner = [d, d - 1, (d + 1) & 7].every((side) => isFree(grid, obstacle, side))
      tape?.write(EVENT.test, cell, obstacle, isCorner ? 1 : 0)
      if (isCorner) mark(cell)
    }
  }
  return isVertex
}

function isFree(grid: Grid, cell: Cell, direction: Direction): boolean {
  const { x, y } = stepped(pointOf(grid.width, cell), direction)
  return !isObstacle(grid, x, y)
}

/**
 * The visibility graph, whose edges are found by looking: all cells with a free simplest path from
 * or to a vertex lie on rays that bend once, so walking these rays finds its neighbours in time
 * that grows with what it sees, not with the number of vertices.
 */
function visibilityRoadmap(problem: Problem, tape: Tape | undefined): Roadmap {
  const { grid, diagonal } = problem
  const legal = allLegalSteps(grid, diagonal)
  const offsets = stepOffsets(grid.width)
  const isVertex = markVertices(problem, tape)
  const places = new Int32Array(grid.walls.length)
  const vertices = Int32Array.from(cellsOf(isVertex))
  vertices.forEach((cell, i) => {
    places[cell] = i
  })

  const walk = (from: Cell, d: Direction, outward: boolean, visit: VisitNeighbour): void => {
    const offset = offsets[d]
    for (let cell = from; (legal[cell] >> d) & 1; ) {
      cell += offset
      if (isVertex[cell]) visit(places[cell], outward)
    }
  }
  const eachNeighbour = (vertex: number, visit: VisitNeighbour): void => {
    for (let d = 0; d < 8; d++) {
      walk(vertices[vertex], d, true, visit)
      for (let cell = vertices[vertex]; (legal[cell] >> d) & 1; ) {
        cell += offsets[d]
        // A simplest path begins with its diagonal part: after a straight ray it is walked backwards.
        walk(cell, (d + 1) & 7, isDiagonal(d), visit)
        walk(cell, (d + 7) & 7, isDiagonal(d), visit)
      }
    }
  }
  return { vertices, eachNeighbour }
}

function* cellsOf(marks: Uint8Array): Generator<number> {
  for (let cell = 0; cell < marks.length; cell++) if (marks[cell]) yield cell
}
