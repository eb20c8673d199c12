import type { Direction } from '../../grid/directions'
import { DIAGONAL_WEIGHT, weightsTo } from '../costs'
import { GoalInSight } from './jump-points/goal-in-sight'
import { jumpGraphOf } from './jump-points/graph'
import { covers } from './jump-points/views'
import { wayBackOverJumps } from './jump-points/way-back'
import { CLOSED, DIRECTION_SHIFT, directionIn, OPEN, openCells } from './memory'
import { Recorder } from './recorder'
import { type Found, PROGRESS_EVERY, type SearchTask } from './search'
import { NO_DIRECTION } from './successors'

/**
 * Jump point search: A* that opens only cells where a shortest path has a choice, and jumps over all
 * others. (D. Harabor and A. Grastien, "Online graph pruning for pathfinding on grid maps", 2011.)
 */
export function jumpPointSearch({
  problem,
  legal,
  cost,
  tape,
  lines,
  progress,
}: SearchTask): Found {
  const { grid, start, goal } = problem
  const cells = grid.walls.length
  const estimate = weightsTo(goal, cost, grid.width)
  const graph = jumpGraphOf(legal, problem, DIAGONAL_WEIGHT[cost])
  const { vertices, edges } = graph
  const goalInSight = new GoalInSight(problem, graph.looks.runs)
  const record = tape && new Recorder(tape, lines, cost)
  const first = graph.madeAt(start)
  const last = graph.madeAt(goal)
  let expanded = 0
  vertices.states.fill(0, 0, vertices.count)
  vertices.states[first] = OPEN | (NO_DIRECTION << DIRECTION_SHIFT)
  vertices.weights[first] = 0
  openCells.begin(first, estimate(start))
  record?.begin(start, goal)

  const reach = (to: number, arrival: Direction, weight: number, from: number, d: Direction) => {
    if (vertices.states[to] !== 0 && weight >= vertices.weights[to]) return
    vertices.states[to] = OPEN | (arrival << DIRECTION_SHIFT)
    vertices.weights[to] = weight
    vertices.setParent(to, from, d)
    const cell = vertices.cell(to)
    openCells.push(to, weight + estimate(cell))
    record?.jumped(cell, vertices.cell(from), weight)
  }

  for (let vertex = openCells.pop(); vertex >= 0; vertex = openCells.pop()) {
    const state = vertices.states[vertex]
    // A vertex that was improved waits in a later place too.
    if (state & CLOSED) continue
    vertices.states[vertex] = state | CLOSED
    const cell = vertices.cell(vertex)
    const weight = vertices.weights[vertex]
    if (++expanded % PROGRESS_EVERY === 0) progress(expanded / cells)
    record?.jumpPointClosed(cell, weight)
    if (vertex === last) {
      return { path: wayBackOverJumps(graph, problem, legal, goalInSight), expanded }
    }
    const ways = graph.ways(vertex, directionIn(state))
    graph.explore(vertex, ways)
    // What is known holds without a goal: ways that may have it in sight are followed anew.
    if (covers(vertices.farViews[vertex], goalInSight.view)) {
      let edge = vertices.edges[vertex] - 1
      for (let d = 0; d < 8; d++) {
        if (((ways >> d) & 1) === 0) continue
        while (edge >= 0 && edges.departure(edge) < d) edge = edges.next(edge)
        const known = edge >= 0 && edges.departure(edge) === d
        if (known && !covers(edges.view(edge), goalInSight.view)) graph.take(edge)
        else graph.follow(vertex, d, goalInSight)
        if (graph.end >= 0) reach(graph.end, graph.arrival, weight + graph.weight, vertex, d)
      }
    } else {
      for (let edge = vertices.edges[vertex] - 1; edge >= 0; edge = edges.next(edge)) {
        const d = edges.departure(edge)
        if (((ways >> d) & 1) === 0) continue
        reach(edges.end(edge), edges.arrival(edge), weight + edges.weight(edge), vertex, d)
      }
    }
  }
  return { path: new Int32Array(0), expanded }
}
