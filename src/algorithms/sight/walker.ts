import type { Cell } from '../../grid/grid'
import { type Edges, outwardAfter, type Rays, type Seen, VERTEX } from './rays'

/** Finds what can be seen from a vertex by walking the rays, step by step. */
export class Walker {
  /** How many steps it walked so far after bends: they are the most. */
  walked = 0
  readonly #rays: Rays
  readonly #edges: Edges

  constructor(rays: Rays, edges: Edges) {
    this.#rays = rays
    this.#edges = edges
  }

  /** See `Sight`. */
  nearest(from: Cell): number {
    const { marks, offsets, weights } = this.#rays
    const { ends, weights: sums, outwards } = this.#edges
    let walked = 0
    let count = 0
    for (let d = 0; d < 8; d++) {
      const outward = outwardAfter(d)
      const offset = offsets[d]
      const aside = weights[outward ^ 1]
      let mark = marks[from]
      let weight = 0
      for (let bend = from; (mark >> d) & 1; ) {
        bend += offset
        weight += weights[outward]
        mark = marks[bend]
        if (mark & VERTEX) {
          ends[count] = bend
          sums[count] = weight
          outwards[count++] = 1
          break
        }
        for (let turn = 7; turn <= 9; turn += 2) {
          const onward = (d + turn) & 7
          const step = offsets[onward]
          let sum = weight
          let seen = mark
          for (let cell = bend; (seen >> onward) & 1; ) {
            cell += step
            sum += aside
            walked++
            seen = marks[cell]
            if (seen & VERTEX) {
              ends[count] = cell
              sums[count] = sum
              outwards[count++] = outward
              break
            }
          }
        }
      }
    }
    this.walked += walked
    return count
  }

  /** See `Sight`. */
  all(from: Cell, seen: Seen): void {
    const { marks, offsets } = this.#rays
    for (let d = 0; d < 8; d++) {
      for (let bend = from; (marks[bend] >> d) & 1; ) {
        bend += offsets[d]
        if (marks[bend] & VERTEX) seen(bend, 1)
        for (let turn = 7; turn <= 9; turn += 2) {
          const onward = (d + turn) & 7
          for (let cell = bend; (marks[cell] >> onward) & 1; ) {
            cell += offsets[onward]
            this.walked++
            if (marks[cell] & VERTEX) seen(cell, outwardAfter(d))
          }
        }
      }
    }
  }
}
