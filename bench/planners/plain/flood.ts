import type { Cell, Grid } from '../../../src/grid/grid'

/**
 * The plainest program that has to look at every cell: a breadth-first search by straight steps on
 * flat arrays, with a border of obstacles around the map. What it takes for a cell is the yardstick
 * of what this machine can do, so it keeps its arrays between its runs.
 */
export class Flood {
  readonly #width: number
  readonly #walls: Uint8Array
  readonly #blocked: Uint8Array
  readonly #distances: Int32Array
  readonly #queue: Int32Array

  constructor({ width, height, walls }: Grid) {
    this.#width = width
    this.#walls = walls
    this.#blocked = new Uint8Array((width + 2) * (height + 2)).fill(1)
    this.#distances = new Int32Array(this.#blocked.length)
    this.#queue = new Int32Array(walls.length)
  }

  /** Goes from a cell to all that straight steps lead to; returns how many cells that are. */
  run(start: Cell): number {
    const stride = this.#width + 2
    const blocked = this.#blocked
    const distances = this.#distances
    const queue = this.#queue
    this.#copyWalls()
    const first = this.#padded(start)
    queue[0] = first
    blocked[first] = 1
    distances[first] = 0
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
    return count
  }

  /** The first `count` cells that the last run came to, the farthest last. */
  reached(count: number): Int32Array {
    const stride = this.#width + 2
    return this.#queue.slice(0, count).map((padded) => {
      const x = padded % stride
      return ((padded - x) / stride - 1) * this.#width + x - 1
    })
  }

  #copyWalls(): void {
    const width = this.#width
    const walls = this.#walls
    for (let from = 0, to = width + 3; from < walls.length; from += width, to += width + 2) {
      this.#blocked.set(walls.subarray(from, from + width), to)
    }
  }

  /** The place of a cell on the map with a border. */
  #padded(cell: Cell): number {
    const x = cell % this.#width
    return ((cell - x) / this.#width + 1) * (this.#width + 2) + x + 1
  }
}
