import type { Cell, Grid } from '../../src/grid/grid'

/** What a flood reached: the cells in the order in which it came to them, of a map with a border. */
export interface Flood {
  /** Cells of the padded map, whose rows are `width + 2` long; the first `count` of them count. */
  readonly queue: Int32Array
  readonly count: number
}

/**
 * The plainest program that has to look at every cell: a breadth-first flood by straight steps, on
 * flat arrays with a border of obstacles around the map. What it takes for a cell is the yardstick
 * of what this machine can do.
 */
export function flood({ width, height, walls }: Grid, start: Cell): Flood {
  const stride = width + 2
  const blocked = new Uint8Array(stride * (height + 2)).fill(1)
  for (let y = 0; y < height; y++) {
    blocked.set(walls.subarray(y * width, y * width + width), (y + 1) * stride + 1)
  }
  const distances = new Int32Array(blocked.length)
  const queue = new Int32Array(width * height)
  queue[0] = paddedCell(width, start)
  blocked[queue[0]] = 1
  let count = 1
  for (let head = 0; head < count; head++) {
    const cell = queue[head]
    const distance = distances[cell] + 1
    const north = cell - stride
    if (blocked[north] === 0) {
      blocked[north] = 1
      distances[north] = distance
      queue[count++] = north
    }
    const east = cell + 1
    if (blocked[east] === 0) {
      blocked[east] = 1
      distances[east] = distance
      queue[count++] = east
    }
    const south = cell + stride
    if (blocked[south] === 0) {
      blocked[south] = 1
      distances[south] = distance
      queue[count++] = south
    }
    const west = cell - 1
    if (blocked[west] === 0) {
      blocked[west] = 1
      distances[west] = distance
      queue[count++] = west
    }
  }
  return { queue, count }
}

/** The place of a cell on the map with a border. */
function paddedCell(width: number, cell: Cell): number {
  const x = cell % width
  return ((cell - x) / width + 1) * (width + 2) + x + 1
}

/** The cell of the map that stands at a place of the map with a border. */
export function unpaddedCell(width: number, padded: number): Cell {
  const x = padded % (width + 2)
  return ((padded - x) / (width + 2) - 1) * width + x - 1
}
