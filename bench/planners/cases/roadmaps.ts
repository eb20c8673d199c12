import type { Cell, Grid } from '../../../src/grid/grid'
import { randomInteger, randomNumbers } from '../../../src/grid/random'
import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask, searchesOf } from '../ours'
import { walkPairs } from '../plain/pairs'
import { allQueries } from '../questions'

/** The visibility graph's time, against grid decomposition's for an answer of the same cost. */
export function visibilityCase(map: BenchMap): Case {
  const work = (planner: string) =>
    allQueries([map], (grid, query) => ask(grid, query, planner, { cost: 'cells' }))
  return {
    name: `visibility graph, ${map.name}`,
    against: 'decomposition',
    ours: work('visibility-graph'),
    peer: work('decomposition'),
    unit: 'query',
    target: { atMost: 20 },
  }
}

const SAMPLES = 10_000
/** All pairs of so many vertices take minutes where they see far: a part is walked, and scaled. */
const WALKED_EVERY = 100

/** A roadmap of many samples, against walking the simplest paths of all its pairs cell by cell. */
export function roadmapCases(map: BenchMap): Case[] {
  const vertices = sampledCells(map.grid)
  const walk = () => walkPairs(map.grid, vertices, WALKED_EVERY, () => {})
  return searchesOf('probabilistic-roadmap').map((search) => {
    const params = { cost: 'euclidean', search, samples: SAMPLES }
    return {
      name: `roadmap ${search}, ${map.name}`,
      against: `walking all pairs (those of 1 vertex in ${WALKED_EVERY}, scaled)`,
      ours: allQueries([map], (grid, query) => ask(grid, query, 'probabilistic-roadmap', params)),
      peer: walk,
      unit: 'query',
      target: { atLeast: 50 },
    }
  })
}

function sampledCells({ walls }: Grid): Int32Array {
  const random = randomNumbers(1)
  const cells = new Set<Cell>()
  while (cells.size < SAMPLES) {
    const cell = randomInteger(random, walls.length)
    if (!walls[cell]) cells.add(cell)
  }
  return Int32Array.from(cells)
}
