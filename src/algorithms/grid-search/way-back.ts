import type { Cell } from '../../grid/grid'
import { DIRECTION, type Memory } from './memory'

/** The cells from the start to `goal`: from each it goes back against the direction of its last step. */
export function wayBack(
  start: Cell,
  goal: Cell,
  { states }: Memory,
  offsets: Int32Array,
): Int32Array {
  let count = 1
  for (let cell = goal; cell !== start; count++) cell -= offsets[states[cell] & DIRECTION]
  const path = new Int32Array(count)
  let cell = goal
  for (let i = count - 1; i > 0; i--) {
    path[i] = cell
    cell -= offsets[states[cell] & DIRECTION]
  }
  path[0] = start
  return path
}

/**
 * The same after jumps, which tell nothing of the cells between: the one before is the first on the
 * way whose own path, with the steps between, weighs the same. Weights are sums without rounding, so
 * they can be compared.
 */
export function wayBackOverJumps(
  start: Cell,
  goal: Cell,
  { states, weights, buckets }: Memory,
  offsets: Int32Array,
  diagonalWeight: number,
): Int32Array {
  // Nobody waits in it: jumps use no buckets.
  const [backwards] = buckets
  for (let cell = goal; cell !== start; ) {
    const direction = states[cell] & DIRECTION
    const offset = offsets[direction]
    const step = direction & 1 ? diagonalWeight : 1
    let weight = weights[cell]
    do {
      backwards.push(cell)
      cell -= offset
      weight -= step
    } while (states[cell] === 0 || weights[cell] !== weight)
  }
  backwards.push(start)
  return backwards.cells.slice(0, backwards.count).reverse()
}
