import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { randomInteger } from '../grid/random'
import { EVENT } from '../trace/events'
import { costParam } from './costs'
import { offlinePlanner } from './planner'
import { roadmapPhases, roadmapPseudocode, roadmapVariables, searchRoadmap } from './roadmap'
import { searchParam } from './search-param'

const { text, line } = roadmapPseudocode({
  vertices: 'random free cells',
  none: 'give up, these samples do not join start and goal',
})

export const probabilisticRoadmap = offlinePlanner({
  id: 'probabilistic-roadmap',
  title: 'Probabilistic roadmap',
  summary:
    'Random free cells are joined wherever the simplest path between them is free; Dijkstra or A* searches that graph.',
  promise:
    'Neither complete nor optimal: with more samples a path is found more often and gets shorter, and the roadmap takes longer to build. The same seed gives the same roadmap.',
  complete: () => false,
  optimal: () => false,
  params: [
    {
      name: 'samples',
      label: 'Samples',
      kind: 'integer',
      min: 0,
      max: 100_000,
      unit: 'cells',
      default: ({ grid }) => grid.width,
      help: 'Random free cells on the roadmap; as many as the map has columns, if nothing else is said.',
    },
    searchParam,
    costParam,
  ],
  usesSeed: true,
  phases: roadmapPhases,
  variables: roadmapVariables,
  pseudocode: text,
  source:
    'Report, IV.C; L. E. Kavraki et al., "Probabilistic roadmaps for path planning in high-dimensional configuration spaces", 1996',

  plan(problem, { params, random, tape, progress }) {
    const { samples, areAll } = sampleFreeCells(problem, params.samples, random)
    const vertices = Int32Array.from([...new Set([problem.start, problem.goal]), ...samples])
    const isVertex = new Uint8Array(problem.grid.walls.length)
    tape?.at(line.vertices).write(EVENT.phase, -1, 0)
    for (const cell of vertices) {
      isVertex[cell] = 1
      tape?.write(EVENT.vertex, cell)
    }
    const failure = {
      status: 'not-found',
      reason: areAll
        ? 'not even all free cells as samples join start and goal'
        : 'these samples do not join start and goal; more samples or another seed may',
    } as const
    const { cost, search } = params
    const task = { problem, cost, search, failure, lines: line, tape, progress }
    return searchRoadmap({ vertices, isVertex }, task)
  },
})

/** Distinct free cells apart from start and goal; all of them if there are no more than `count`. */
function sampleFreeCells(
  problem: Problem,
  count: number,
  random: () => number,
): { samples: Int32Array; areAll: boolean } {
  const { grid, start, goal } = problem
  const isCandidate = (cell: Cell) => !grid.walls[cell] && cell !== start && cell !== goal
  let free = 0
  const cells = new Int32Array(grid.walls.length)
  for (let cell = 0; cell < cells.length; cell++) if (isCandidate(cell)) cells[free++] = cell
  const drawn = Math.min(count, free)
  for (let i = 0; i < drawn; i++) {
    const j = i + randomInteger(random, free - i)
    const cell = cells[j]
    cells[j] = cells[i]
    cells[i] = cell
  }
  return { samples: cells.subarray(0, drawn), areAll: drawn === free }
}
