import type { Problem } from '../grid/problem'
import type { Param, ValuesOf } from './params'

export type RepulsionDistance = 'euclidean' | 'manhattan'

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
  readonly attraction: Float64Array
  readonly repulsion: Float64Array
  readonly potential: Float64Array
}

export function fieldsOf(problem: Problem, settings: Settings): Fields {
  const attraction = attractionOf(problem)
  const repulsion = repulsionOf(problem, settings)
  const potential = attraction.map((value, cell) => value + repulsion[cell])
  return { attraction, repulsion, potential }
}

function attractionOf({ grid, goal }: Problem): Float64Array {
  const goalX = goal % grid.width
  const goalY = Math.floor(goal / grid.width)
  const attraction = new Float64Array(grid.walls.length)
  for (let cell = 0, y = 0; y < grid.height; y++) {
    for (let x = 0; x < grid.width; x++, cell++) {
      attraction[cell] = (x - goalX) ** 2 + (y - goalY) ** 2
    }
  }
  return attraction
}

function repulsionOf(
  { grid, goal }: Problem,
  { influence, repulsiveValue, repulsionDistance }: Settings,
): Float64Array {
  const { width, height, walls } = grid
  const strengths = strengthTable(influence, repulsiveValue, repulsionDistance)
  const inRow = distancesInRow(walls, width, influence)
  const side = influence + 1
  const repulsion = new Float64Array(walls.length)
  for (let cell = 0, y = 0; y < height; y++) {
    const above = Math.min(influence, y)
    const below = Math.min(influence, height - 1 - y)
    for (let x = 0; x < width; x++, cell++) {
      if (walls[cell]) {
        repulsion[cell] = Number.POSITIVE_INFINITY
        continue
      }
      let strongest = 0
      for (let dy = -above; dy <= below; dy++) {
        const dx = inRow[cell + dy * width]
        if (dx > influence) continue
        const strength = strengths[Math.abs(dy) * side + dx]
        if (strength > strongest) strongest = strength
      }
      repulsion[cell] = strongest
    }
  }
  repulsion[goal] = 0
  return repulsion
}

/** Repulsion by how many rows and columns away the obstacle is. The closest is the strongest. */
function strengthTable(
  influence: number,
  repulsiveValue: number,
  measure: RepulsionDistance,
): Float64Array {
  const side = influence + 1
  return Float64Array.from({ length: side * side }, (_, i) => {
    const dx = i % side
    const dy = Math.floor(i / side)
    if (i === 0) return 0
    return repulsiveValue / (measure === 'euclidean' ? Math.sqrt(dx * dx + dy * dy) : dx + dy)
  })
}

/** For each cell how many columns away the closest obstacle of its row is; 255 if not in reach. */
function distancesInRow(walls: Uint8Array, width: number, reach: number): Uint8Array {
  const far = 255
  const distances = new Uint8Array(walls.length)
  for (let first = 0; first < walls.length; first += width) {
    let d = far
    for (let cell = first; cell < first + width; cell++) {
      d = walls[cell] ? 0 : d >= reach ? far : d + 1
      distances[cell] = d
    }
    d = far
    for (let cell = first + width - 1; cell >= first; cell--) {
      d = walls[cell] ? 0 : d >= reach ? far : d + 1
      if (d < distances[cell]) distances[cell] = d
    }
  }
  return distances
}
