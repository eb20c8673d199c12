import type { Cell } from '../../grid/grid'
import { type Edges, outwardAfter, type Rays, type Seen, VERTEX } from './rays'

/**
 * Finds what can be seen from a vertex by look-ups, in a table of how far each cell is clear in each
 * of the 8 directions. Filled in one pass over the map.
 */
export class ClearTable {
  readonly #rays: Rays
  readonly #edges: Edges
  /**
   * At `cell << 3 | direction` the steps to the first vertex there; if there is none, minus the
   * steps that are free.
   */
  readonly #steps: Int16Array

  constructor(rays: Rays, edges: Edges) {
    this.#rays = rays
    this.#edges = edges
    this.#steps = clearSteps(rays)
  }

  /** See `Sight`. */
  nearest(from: Cell): number {
    const { offsets, weights } = this.#rays
    const { ends, weights: sums, outwards } = this.#edges
    const steps = this.#steps
    let count = 0
    for (let d = 0; d < 8; d++) {
      const outward = outwardAfter(d)
      const offset = offsets[d]
      const along = weights[outward]
      const aside = weights[outward ^ 1]
      const ahead = steps[(from << 3) | d]
      const bends = ahead > 0 ? ahead - 1 : -ahead
      for (let i = 1, bend = from + offset; i <= bends; i++, bend += offset) {
        for (let turn = 7; turn <= 9; turn += 2) {
          const onward = (d + turn) & 7
          const more = steps[(bend << 3) | onward]
          if (more <= 0) continue
          ends[count] = bend + more * offsets[onward]
          sums[count] = i * along + more * aside
          outwards[count++] = outward
        }
      }
      if (ahead > 0) {
        ends[count] = from + ahead * offset
        sums[count] = ahead * along
        outwards[count++] = 1
      }
    }
    return count
  }

  /** See `Sight`. */
  all(from: Cell, seen: Seen): void {
    const { marks, offsets } = this.#rays
    const steps = this.#steps
    for (let d = 0; d < 8; d++) {
      for (let bend = from; (marks[bend] >> d) & 1; ) {
        bend += offsets[d]
        if (marks[bend] & VERTEX) seen(bend, 1)
        for (let turn = 7; turn <= 9; turn += 2) {
          const onward = (d + turn) & 7
          let vertex = bend
          for (let more = steps[(vertex << 3) | onward]; more > 0; ) {
            vertex += more * offsets[onward]
            seen(vertex, outwardAfter(d))
            more = steps[(vertex << 3) | onward]
          }
        }
      }
    }
  }
}

function clearSteps({ marks, offsets }: Rays): Int16Array {
  const steps = new Int16Array(8 * marks.length)
  const fill = (cell: Cell, d: number): void => {
    if (((marks[cell] >> d) & 1) === 0) return
    const next = cell + offsets[d]
    const onward = steps[(next << 3) | d]
    steps[(cell << 3) | d] = marks[next] & VERTEX ? 1 : onward > 0 ? onward + 1 : onward - 1
  }
  // West, north-west, north and north-east lead to cells that come before.
  for (let cell = 0; cell < marks.length; cell++) {
    for (let d = 6; d <= 9; d++) fill(cell, d & 7)
  }
  for (let cell = marks.length - 1; cell >= 0; cell--) {
    for (let d = 2; d <= 5; d++) fill(cell, d)
  }
  return steps
}
