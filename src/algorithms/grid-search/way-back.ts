import type { Cell } from '../../grid/grid'
import { DIRECTION, type Memory } from './memory'

/**
 * The cells from the start to `goal`, which was reached. From a cell it goes back against the
 * direction of its last step; the cell before is the first one there whose own path, with the steps
 * between, weighs the same. Weights are sums without rounding, so they can be compared.
 */
export function wayBack(
  start: Cell,
  goal: Cell,
  { states, weights, buckets }: Memory,
  offsets: Int32Array,
  diagonalWeight: number,
): Int32Array {
  // Nothing waits any more once the goal is reached.
  const [backwards] = buckets
  backwards.count = 0
  let weight = weights[goal]
  let direction = 0
  for (let cell = goal; cell !== start; cell -= offsets[direction]) {
    backwards.push(cell)
    if (states[cell] !== 0 && weights[cell] === weight) direction = states[cell] & DIRECTION
    weight -= direction & 1 ? diagonalWeight : 1
  }
  backwards.push(start)
  const { cells, count } = backwards
  const path = new Int32Array(count)
  for (let i = 0; i < count; i++) path[i] = cells[count - 1 - i]
  return path
}
