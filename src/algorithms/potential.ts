import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { closestObstacles, noneInReach, type Reach } from './closest-obstacle'
import type { Param, ValuesOf } from './params'

export const potentialParams = [
  {
    name: 'influence',
    label: 'Influence',
    kind: 'integer',
    min: 0,
    max: 100,
    unit: 'cells',
    default: 1,
    help: 'How far obstacles repel: a square of so many cells around each; 0 switches repulsion off.',
  },
  {
    name: 'repulsiveValue',
    label: 'Repulsive value',
    kind: 'number',
    min: 0,
    max: 1_000_000,
    unit: '',
    default: 30,
    help: 'How strongly obstacles repel: this value divided by the distance to the closest one.',
  },
  {
    name: 'repulsionDistance',
    label: 'Repulsion distance',
    kind: 'choice',
    choices: ['euclidean', 'manhattan'],
    default: 'euclidean',
    help: 'How the distance to the closest obstacle is measured: as in the report, or as its program did.',
  },
] as const satisfies readonly Param[]

type Settings = ValuesOf<typeof potentialParams>

/**
 * The fields over all cells (report, IV.D): attraction (x − xg)² + (y − yg)²; repulsion
 * `repulsiveValue` / distance where the closest obstacle lies within `influence` cells, but not at
 * the goal; and their sum. Obstacles are infinite; the border of the map repels nothing.
 */
export interface Fields {
  attraction(cell: Cell): number
  repulsion(cell: Cell): number
  potential(cell: Cell): number
}

export function fieldsOf({ grid, goal }: Problem, settings: Settings): Fields {
  const { width } = grid
  const goalY = Math.floor(goal / width)
  const goalX = goal - goalY * width
  const reach = { influence: settings.influence, measure: settings.repulsionDistance }
  const closest = closestObstacles(grid, reach)
  const strengths = strengthTable(reach, settings.repulsiveValue)

  const attraction = (cell: Cell): number => {
    const y = Math.floor(cell / width)
    const dx = cell - y * width - goalX
    const dy = y - goalY
    return dx * dx + dy * dy
  }
  const repulsion = (cell: Cell): number => (cell === goal ? 0 : strengths[closest[cell]])
  const potential = (cell: Cell): number => attraction(cell) + repulsion(cell)
  return { attraction, repulsion, potential }
}

/** Repulsion by the measure of the closest obstacle: infinite on it, 0 if there is none. */
function strengthTable(reach: Reach, repulsiveValue: number): Float64Array {
  const none = noneInReach(reach)
  return Float64Array.from({ length: none + 1 }, (_, measure) => {
    if (measure === 0) return Number.POSITIVE_INFINITY
    if (measure === none) return 0
    return repulsiveValue / (reach.measure === 'euclidean' ? Math.sqrt(measure) : measure)
  })
}
