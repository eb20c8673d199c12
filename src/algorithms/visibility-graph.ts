import { opposite, stepped } from '../grid/directions'
import { type Cell, isInside, pointOf } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { costParam } from './costs'
import { offlinePlanner } from './planner'
import {
  type Roadmap,
  roadmapPhases,
  roadmapPseudocode,
  roadmapVariables,
  searchRoadmap,
} from './roadmap'
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
    'Complete: it proves it if no path exists. Optimal with only-when-no-obstacles and cost cells; with the report’s rule on about 4 of 5 maps of random obstacles, but seldom in rooms and hardly ever in mazes, because a path may cut a corner that the graph’s vertices go around.',
  complete: () => true,
  optimal: ({ cost }, diagonal) => cost === 'cells' && diagonal === 'only-when-no-obstacles',
  params: [searchParam, costParam],
  phases: roadmapPhases,
  variables: roadmapVariables,
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

/** Its vertices are start, goal, and the free corners of obstacles (Fig. 4). */
function visibilityRoadmap(problem: Problem, tape: Tape | undefined): Roadmap {
  const { grid, start, goal, diagonal } = problem
  const legal = allLegalSteps(grid, diagonal)
  const isVertex = new Uint8Array(legal.length)
  let count = 0
  for (let cell = 0; cell < legal.length; cell++) {
    const vertex = CORNERS[legal[cell]] !== 0 || cell === start || cell === goal ? 1 : 0
    isVertex[cell] = vertex
    count += vertex
  }
  const vertices = new Int32Array(count)
  for (let cell = 0, i = 0; i < count; cell++) if (isVertex[cell]) vertices[i++] = cell
  if (tape) recordVertices(problem, legal, tape)
  return { vertices, isVertex }
}

/**
 * By the legal steps of a cell the diagonal directions in which an obstacle has its corner there:
 * those in which a step is illegal although both beside it are legal, under both rules.
 */
const CORNERS = Uint8Array.from({ length: 256 }, (_, legal) => {
  let corners = 0
  for (let d = 1; d < 8; d += 2) {
    const free = (1 << (d - 1)) | (1 << ((d + 1) & 7))
    if ((legal & (free | (1 << d))) === free) corners |= 1 << d
  }
  return corners
})

/** Writes down how each obstacle's corners are tried. */
function recordVertices({ grid, start, goal }: Problem, legal: Uint8Array, tape: Tape): void {
  const known = new Uint8Array(legal.length)
  const add = (cell: Cell) => {
    if (known[cell]) return
    known[cell] = 1
    tape.write(EVENT.vertex, cell)
  }
  add(start)
  add(goal)
  for (let obstacle = 0; obstacle < legal.length; obstacle++) {
    if (!grid.walls[obstacle]) continue
    const place = pointOf(grid.width, obstacle)
    for (let d = 1; d < 8; d += 2) {
      const { x, y } = stepped(place, d)
      if (!isInside(grid, x, y)) continue
      const cell = y * grid.width + x
      const isCorner = (CORNERS[legal[cell]] >> opposite(d)) & 1
      tape.write(EVENT.test, cell, obstacle, isCorner)
      if (isCorner) add(cell)
    }
  }
}
