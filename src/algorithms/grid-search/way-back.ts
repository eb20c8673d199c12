import { stepOffsets } from '../../grid/directions'
import type { Problem } from '../../grid/problem'
import { Bucket } from './bucket'
import { CLOSED, DIRECTION, DIRECTION_SHIFT, type Memory } from './memory'

// Used again and again; what it holds is copied out.
const back = new Bucket()

/**
 * The cells from the start to the goal, if the goal is closed: from each it goes back against the
 * direction of its last step. Else there is no path, and no cells.
 */
export function wayBack({ grid, start, goal }: Problem, { states }: Memory): Int32Array {
  if ((states[goal] & CLOSED) === 0) return new Int32Array(0)
  const offsets = stepOffsets(grid.width)
  back.count = 0
  for (let cell = goal; cell !== start; ) {
    const arrival = states[cell] & DIRECTION
    const offset = offsets[arrival >> DIRECTION_SHIFT]
    // Most steps are like the one before. To look up where each leads would keep the next one waiting.
    do {
      back.push(cell)
      cell -= offset
    } while ((states[cell] & DIRECTION) === arrival)
  }
  back.push(start)
  const { cells, count } = back
  const path = new Int32Array(count)
  for (let i = 0; i < count; i++) path[i] = cells[count - 1 - i]
  return path
}
