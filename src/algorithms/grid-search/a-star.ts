import { stepOffsets } from '../../grid/directions'
import type { Directions } from '../../grid/steps'
import { DIAGONAL_WEIGHT, weightsTo } from '../costs'
import { CLOSED, DIRECTION_SHIFT, LEGAL, type Memory, OPEN, openCells, STEPS } from './memory'
import { overCells } from './over-cells'
import { Recorder } from './recorder'
import { PROGRESS_EVERY, type SearchTask } from './search'
import { NO_DIRECTION, successorsUnder } from './successors'

const STRAIGHT: Directions = 0b01010101

/**
 * A* with the weight of the simplest path to the goal as its estimate. No path weighs less, so the
 * way to a cell that is closed is final. (P. E. Hart, N. J. Nilsson and B. Raphael, "A formal basis
 * for the heuristic determination of minimum cost paths", 1968.)
 *
 * A step straight for the goal makes the way longer by what it takes from the estimate, so its cell
 * comes next of all: over open ground the search runs to the goal. Diagonal steps are opened last, so
 * that they are taken first: after a straight one a way may not turn diagonal again unless around an
 * obstacle.
 */
export const aStar = overCells(search)

function search(
  { problem, legal, cost, tape, lines, progress }: SearchTask,
  memory: Memory,
): number {
  const { grid, start, goal, diagonal } = problem
  const cells = grid.walls.length
  const successors = successorsUnder(diagonal)
  const offsets = stepOffsets(grid.width)
  const diagonalWeight = DIAGONAL_WEIGHT[cost]
  const estimate = weightsTo(goal, cost, grid.width)
  const { states, weights } = memory
  const record = tape && new Recorder(tape, lines, cost)
  let expanded = 0
  states.set(legal)
  states[start] |= OPEN | (NO_DIRECTION << DIRECTION_SHIFT)
  weights[start] = 0
  openCells.begin(start, estimate(start))
  record?.begin(start, goal)
  for (let cell = openCells.pop(); cell >= 0; cell = openCells.pop()) {
    const state = states[cell]
    // A cell that was improved waits in a later place too.
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
      const direction = 31 - Math.clz32(steps & STRAIGHT || steps)
      steps ^= 1 << direction
      const neighbour = cell + offsets[direction]
      const known = states[neighbour]
      if (known & CLOSED) continue
      const longer = weight + (direction & 1 ? diagonalWeight : 1)
      if (known & OPEN && longer >= weights[neighbour]) continue
      states[neighbour] = OPEN | (direction << DIRECTION_SHIFT) | (known & LEGAL)
      weights[neighbour] = longer
      openCells.push(neighbour, longer + estimate(neighbour))
      opened |= 1 << direction
    }
    record?.closed(cell, opened)
  }
  return expanded
}
