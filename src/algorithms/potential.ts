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

/**
 * The potential of every cell (report, IV.D): attraction (x − xg)² + (y − yg)², plus
 * `repulsiveValue` / distance where the closest obstacle lies within `influence` cells, but not at
 * the goal. Obstacles are infinite; the border of the map repels nothing.
 */
export function potentialOf(
  { grid, goal }: Problem,
  { influence, repulsiveValue, repulsionDistance }: ValuesOf<typeof potentialParams>,
): Float64Array {
  const { width, height, walls } = grid
  const goalX = goal % width
  const goalY = Math.floor(goal / width)
  const repulsions = repulsionTable(influence, repulsiveValue, repulsionDistance)
  const inRow = distancesInRow(walls, width, influence)
  const side = influence + 1
  const potential = new Float64Array(walls.length)
  for (let y = 0; y < height; y++) {
    const above = Math.min(influence, y)
    const below = Math.min(influence, height - 1 - y)
    for (let x = 0; x < width; x++) {
      const cell = y * width + x
      if (walls[cell]) {
        potential[cell] = Number.POSITIVE_INFINITY
        continue
      }
      let repulsion = 0
      for (let dy = -above; dy <= below; dy++) {
        const dx = inRow[cell + dy * width]
        if (dx > influence) continue
        const strength = repulsions[Math.abs(dy) * side + dx]
        if (strength > repulsion) repulsion = strength
      }
      const attraction = (x - goalX) ** 2 + (y - goalY) ** 2
      potential[cell] = attraction + (cell === goal ? 0 : repulsion)
    }
  }
  return potential
}

/** Repulsion by how many rows and columns away the obstacle is. The closest is the strongest. */
function repulsionTable(
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
