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
  /** The sum at one cell. */
  potential(cell: Cell): number
  attraction(): Float64Array
  repulsion(): Float64Array
}

export function fieldsOf({ grid, goal }: Problem, settings: Settings): Fields {
  const { width, height } = grid
  const goalY = Math.floor(goal / width)
  const goalX = goal - goalY * width
  const reach = { influence: settings.influence, measure: settings.repulsionDistance }
  const closest = closestObstacles(grid, reach)
  const strengths = strengthTable(reach, settings.repulsiveValue)

  const attractionAt = (x: number, y: number) => (x - goalX) ** 2 + (y - goalY) ** 2
  const repulsionAt = (cell: Cell) => (cell === goal ? 0 : strengths[closest[cell]])
  return {
    potential(cell) {
      const y = Math.floor(cell / width)
      return attractionAt(cell - y * width, y) + repulsionAt(cell)
    },
    attraction() {
      const field = new Float64Array(closest.length)
      for (let cell = 0, y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) field[cell++] = attractionAt(x, y)
      }
      return field
    },
    repulsion() {
      const field = new Float64Array(closest.length)
      for (let cell = 0; cell < field.length; cell++) field[cell] = repulsionAt(cell)
      return field
    },
  }
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
