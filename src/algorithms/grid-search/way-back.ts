import type { Cell } from '../../grid/grid'
import { directionIn, type Memory } from './memory'

/** The cells from the start to `goal`: from each it goes back against the direction of its last step. */
export function wayBack(
  start: Cell,
  goal: Cell,
  { states }: Memory,
  offsets: Int32Array,
): Int32Array {
  let count = 1
  for (let cell = goal; cell !== start; count++) cell -= offsets[directionIn(states[cell])]
  const path = new Int32Array(count)
  let cell = goal
  for (let i = count - 1; i > 0; i--) {
    path[i] = cell
    cell -= offsets[directionIn(states[cell])]
  }
  path[0] = start
  return path
}
