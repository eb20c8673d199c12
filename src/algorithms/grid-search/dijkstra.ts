import { stepOffsets } from '../../grid/directions'
import type { Directions } from '../../grid/steps'
import { DIAGONAL_WEIGHT } from '../costs'
import { CLOSED, DIRECTION_SHIFT, LEGAL, type Memory, OPEN, STEPS, UNIT } from './memory'
import { overCells } from './over-cells'
import { Recorder } from './recorder'
import { PROGRESS_EVERY, type SearchTask } from './search'
import { NO_DIRECTION, successorsUnder } from './successors'

/**
 * Dijkstra's algorithm without a heap: cells wait in buckets one unit of weight wide. No step weighs
 * less than that, so the cells of one bucket cannot improve each other, any order among them is
 * right, and three buckets in turn hold all that wait. (R. B. Dial, 1969.)
 */
export const dijkstra = overCells(search)

function search(
  { problem, legal, cost, tape, lines, progress }: SearchTask,
  memory: Memory,
): number {
  const { grid, start, goal, diagonal } = problem
  const cells = grid.walls.length
  const successors = successorsUnder(diagonal)
  const offsets = stepOffsets(grid.width)
  const diagonalWeight = (DIAGONAL_WEIGHT[cost] * UNIT) | 0
  const { states, wholeWeights: weights } = memory
  let bucket = memory.buckets[0]
  let next = memory.buckets[1]
  let afterNext = memory.buckets[2]
  const record = tape && new Recorder(tape, lines, cost)
  let expanded = 0
  states.set(legal)
  states[start] |= OPEN | (NO_DIRECTION << DIRECTION_SHIFT)
  weights[start] = 0
  bucket.push(start)
  record?.begin(start, null)
  for (let units = 0; bucket.count + next.count > 0; units++) {
    const least = units << 29
    // Nothing joins this bucket any more, and the others are given all the room that its cells could
    // need, so that neither is asked for each of them.
    const { cells: waiting, count } = bucket
    next.makeRoom(8 * count)
    afterNext.makeRoom(8 * count)
    const { cells: nextCells } = next
    const { cells: afterNextCells } = afterNext
    let nextCount = next.count
    let afterNextCount = afterNext.count
    for (let i = 0; i < count; i++) {
      const cell = waiting[i]
      const state = states[cell]
      // A cell that was improved stands in an earlier place too.
      if (state & CLOSED) continue
      states[cell] = state | CLOSED
      const weight = weights[cell]
      if (++expanded % PROGRESS_EVERY === 0) progress(expanded / cells)
      if (cell === goal) {
        record?.closed(cell, 0)
        return expanded
      }
      let opened: Directions = 0
      let steps = successors[state & STEPS]
      while (steps !== 0) {
        const direction = 31 - Math.clz32(steps)
        steps ^= 1 << direction
        const neighbour = cell + offsets[direction]
        const known = states[neighbour]
        if (known & CLOSED) continue
        const longer = (weight + (direction & 1 ? diagonalWeight : UNIT)) | 0
        if (known & OPEN && ((longer - weights[neighbour]) | 0) >= 0) continue
        states[neighbour] = OPEN | (direction << DIRECTION_SHIFT) | (known & LEGAL)
        weights[neighbour] = longer
        if (((longer - least) | 0) < 2 * UNIT) nextCells[nextCount++] = neighbour
        else afterNextCells[afterNextCount++] = neighbour
        opened |= 1 << direction
      }
      record?.closed(cell, opened)
    }
    next.count = nextCount
    afterNext.count = afterNextCount
    const empty = bucket
    empty.count = 0
    bucket = next
    next = afterNext
    afterNext = empty
  }
  return expanded
}
