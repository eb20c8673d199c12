import type { Grid } from '../grid/grid'

/** How far obstacles repel and how their distance is measured. */
export interface Reach {
  /** Half the side of the square around a cell within which obstacles count; 254 at most. */
  readonly influence: number
  readonly measure: 'euclidean' | 'manhattan'
}

/** More than the measure of any obstacle in reach: none is. */
export const noneInReach = ({ influence, measure }: Reach): number =>
  measure === 'euclidean' ? 2 * influence ** 2 + 1 : 2 * influence + 1

const FAR = 255

/**
 * For each cell how far the closest obstacle is that lies within the square of `influence` cells
 * around it: dx² + dy², or dx + dy with `manhattan`; 0 for obstacles, `noneInReach` if there is none.
 *
 * In time linear in the cells whatever the influence, after Meijster, Roerdink and Hesselink, "A
 * general algorithm for computing distance transforms in linear time", 2000: first down each column,
 * then along each row, where each column's closest obstacle is the closest of all for one stretch of
 * the row. Here a stretch also ends where that obstacle is out of reach.
 */
export function closestObstacles(grid: Grid, reach: Reach): Uint16Array {
  const { width, walls } = grid
  const { influence } = reach
  const isEuclidean = reach.measure === 'euclidean'
  const none = noneInReach(reach)
  const inColumn = distancesInColumn(grid, influence)
  const closest = new Uint16Array(walls.length)
  // The columns that have a stretch of the row, their part of the measure, and where it begins.
  const columns = new Int32Array(width)
  const parts = new Int32Array(width)
  const begins = new Int32Array(width + 1)
  for (let first = 0; first < walls.length; first += width) {
    let count = 0
    for (let x = 0; x < width; x++) {
      const distance = inColumn[first + x]
      if (distance === FAR) continue
      const part = isEuclidean ? distance * distance : distance
      let begin = x - influence
      for (; count > 0; count--) {
        const before = columns[count - 1]
        const more = part - parts[count - 1]
        const closer = isEuclidean
          ? closerFromEuclidean(before, x, more)
          : closerFromManhattan(before, x, more)
        begin = Math.max(x - influence, Math.min(closer, before + influence + 1))
        // What is overtaken before it begins has no stretch.
        if (begin > begins[count - 1]) break
      }
      columns[count] = x
      parts[count] = part
      begins[count] = begin
      count++
    }
    if (count === 0) {
      closest.fill(none, first, first + width)
      continue
    }
    begins[count] = width
    for (let x = 0, i = 0; x < width; x++) {
      while (begins[i + 1] <= x) i++
      const across = Math.abs(x - columns[i])
      const isInReach = across <= influence
      closest[first + x] = isInReach ? parts[i] + (isEuclidean ? across * across : across) : none
    }
  }
  return closest
}

/**
 * The first x from which on column `b` is at least as close as column `a`, left of it, when its part
 * of the measure is by `more` larger.
 */
function closerFromEuclidean(a: number, b: number, more: number): number {
  return Math.ceil((b * b - a * a + more) / (2 * (b - a)))
}

function closerFromManhattan(a: number, b: number, more: number): number {
  if (more > b - a) return Number.POSITIVE_INFINITY
  return more <= a - b ? Number.NEGATIVE_INFINITY : Math.ceil((a + b + more) / 2)
}

/** For each cell how many rows away the closest obstacle of its column is; FAR if not in reach. */
function distancesInColumn({ width, walls }: Grid, influence: number): Uint8Array {
  const distances = new Uint8Array(walls.length).fill(FAR, 0, width)
  const after = (distance: number) => (distance >= influence ? FAR : distance + 1)
  for (let cell = 0; cell < walls.length; cell++) {
    if (walls[cell]) distances[cell] = 0
    else if (cell >= width) distances[cell] = after(distances[cell - width])
  }
  for (let cell = walls.length - width - 1; cell >= 0; cell--) {
    const distance = after(distances[cell + width])
    if (distance < distances[cell]) distances[cell] = distance
  }
  return distances
}
