import { EVENT, Tape } from 'path-planner'
import type { Fault } from './check'
import type { BenchMap } from './maps'
import { ask, searchesOf } from './ours'
import { edgesAmong, leastOverEdges } from './plain/roadmap'

/** Few enough for all pairs to be walked, and enough to join most starts and goals. */
const SAMPLES = 400

/** Whether our roadmaps have the edges that walking all pairs finds, and the shortest way over them. */
export function roadmapFaultsOn(map: BenchMap): Fault[] {
  const { grid, queries } = map
  return queries.flatMap((query) =>
    searchesOf('probabilistic-roadmap').flatMap((search) => {
      const who = `probabilistic-roadmap ${search}`
      const params = { cost: 'euclidean', search, samples: SAMPLES }
      const tape = new Tape()
      const recorded = ask(grid, query, 'probabilistic-roadmap', params, tape)
      const { status, cost } = ask(grid, query, 'probabilistic-roadmap', params)
      const edges = edgesAmong(grid, cellsOf(tape, EVENT.vertex))
      const least = leastOverEdges(grid.width, edges, query.start, query.goal)
      const found = status === 'reached' ? cost : Number.POSITIVE_INFINITY
      const fault = { who, isOurs: true, map, query, cost: found, least }
      if (found !== least && !(Math.abs(found - least) < 1e-6)) return [fault]
      if (recorded.status !== status || recorded.cost !== cost) {
        return [{ ...fault, error: 'another answer with a tape' }]
      }
      const drawn = cellsOf(tape, EVENT.edge).length
      return drawn === edges.length
        ? []
        : [{ ...fault, error: `${drawn} edges, but walking finds ${edges.length}` }]
    }),
  )
}

/** The cells of all events of a kind. */
function cellsOf(tape: Tape, kind: number): number[] {
  const events = Array.from({ length: tape.length }, (_, i) => i)
  return events.filter((i) => tape.kind(i) === kind).map((i) => tape.cell(i))
}
