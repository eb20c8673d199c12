import { EVENT, type Tape } from '../../src/index'
import { isClose, must } from './cases'
import { type Edge, shortestOnRoadmap } from './roadmap'
import type { Run } from './run'
import { type CostName, lengthOf } from './shortest'
import { isSame, placesOf, type World, type XY } from './world'

/** The path is as long as the shortest one on the roadmap, or neither exists. */
export function mustBeBestOnRoadmap(
  world: World,
  { name, outcome }: Run,
  vertices: readonly XY[],
  edges: readonly Edge[],
  cost: CostName,
): void {
  const start = vertices.findIndex((cell) => isSame(cell, world.start))
  const goal = vertices.findIndex((cell) => isSame(cell, world.goal))
  const best = shortestOnRoadmap(vertices.length, edges, start, goal, cost)
  must((outcome.status === 'reached') === (best !== undefined), () => `${name}: ${outcome.status}`)
  const { expanded } = outcome
  must(expanded <= vertices.length, () => `${name}: ${expanded} of ${vertices.length} expanded`)
  if (!best) return
  const least = cost === 'cells' ? best.steps : lengthOf(best)
  must(isClose(outcome.cost, least), () => `${name}: costs ${outcome.cost} instead of ${least}`)
  must(
    isClose(outcome.measure.length, lengthOf(best)),
    () => `${name}: is ${outcome.measure.length} long instead of ${lengthOf(best)}`,
  )
}

/** A* ends as Dijkstra does and expands no more; that its cost is the least is for others to check. */
export function mustBeAsGood(starred: Run, { outcome }: Run): void {
  const { name } = starred
  const { status, expanded } = starred.outcome
  must(status === outcome.status, () => `${name}: ${status}, but dijkstra ${outcome.status}`)
  must(
    expanded <= outcome.expanded,
    () => `${name}: ${expanded} expanded, but dijkstra ${outcome.expanded}`,
  )
  // Without a path both try all that is joined to the start.
  must(
    status === 'reached' || expanded === outcome.expanded,
    () => `${name}: ${expanded} expanded without a path, but dijkstra ${outcome.expanded}`,
  )
}

/** The tape shows these vertices, each once, and these edges, each once and with its weight. */
export function mustHaveOnTape(
  world: World,
  name: string,
  tape: Tape,
  vertices: readonly XY[],
  edges: readonly Edge[],
  cost: CostName,
): void {
  const drawnVertices: string[] = []
  const drawnEdges = new Map<string, number>()
  for (let i = 0; i < tape.length; i++) {
    if (tape.kind(i) === EVENT.vertex) {
      drawnVertices.push(String(placesOf(world, [tape.cell(i)])[0]))
    } else if (tape.kind(i) === EVENT.edge) {
      const key = edgeName(placesOf(world, [tape.cell(i), tape.other(i)]))
      must(!drawnEdges.has(key), () => `${name}: edge ${key} is on the tape twice`)
      drawnEdges.set(key, tape.value(i))
    }
  }
  const expected = vertices.map(String).sort().join(' ')
  const drawn = drawnVertices.sort().join(' ')
  must(drawn === expected, () => `${name}: vertices ${drawn} instead of ${expected}`)
  must(
    drawnEdges.size === edges.length,
    () => `${name}: ${drawnEdges.size} edges instead of ${edges.length}`,
  )
  for (const { from, to, way } of edges) {
    const key = edgeName([vertices[from], vertices[to]])
    const weight = drawnEdges.get(key)
    const expectedWeight = cost === 'cells' ? way.steps : lengthOf(way)
    must(
      weight !== undefined && isClose(weight, expectedWeight),
      () => `${name}: edge ${key} weighs ${weight} instead of ${expectedWeight}`,
    )
  }
}

const edgeName = (ends: readonly XY[]): string => ends.map(String).sort().join(' – ')
