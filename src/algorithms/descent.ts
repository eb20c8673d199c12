import { directionOf, stepOffsets } from '../grid/directions'
import { type Cell, cellName } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { allLegalSteps } from '../grid/steps'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import type { Answer } from './planner'

/** Among equal neighbours the first of these wins: columns x+1, x, x−1, in each y−1, y, y+1. */
const ORDER = [
  [1, -1],
  [1, 0],
  [1, 1],
  [0, -1],
  [0, 1],
  [-1, -1],
  [-1, 0],
  [-1, 1],
].map(([dx, dy]) => directionOf(dx, dy))

interface Descent {
  readonly problem: Problem
  readonly potential: Float64Array
  /** Whether cells already visited are closed to the agent, and steps upwards open to it. */
  readonly memory: boolean
  readonly lines: Readonly<Record<'field' | 'choose' | 'step' | 'stuck', number>>
  readonly tape: Tape | undefined
}

/** Steps to the legal neighbour with the lowest potential until the goal is reached or none is left. */
export function descend(task: Descent): Answer {
  const { problem, potential, memory, lines, tape } = task
  const { width } = problem.grid
  const legal = allLegalSteps(problem.grid, problem.diagonal)
  const offsets = stepOffsets(width)
  const visited = new Uint8Array(potential.length)
  const path: Cell[] = []
  const visit = (cell: Cell): void => {
    tape?.at(lines.step).write(EVENT.step, cell, path.at(-1), potential[cell])
    path.push(cell)
    visited[cell] = 1
  }
  const lowestNeighbour = (cell: Cell): Cell => {
    let lowest = -1
    for (const d of ORDER) {
      const next = cell + offsets[d]
      if (((legal[cell] >> d) & 1) === 0 || (memory && visited[next])) continue
      if (lowest < 0 || potential[next] < potential[lowest]) lowest = next
    }
    return lowest
  }

  if (tape) {
    tape.at(lines.field)
    for (let cell = 0; cell < potential.length; cell++) {
      tape.write(EVENT.potential, cell, -1, potential[cell])
    }
  }
  let here = problem.start
  visit(here)
  while (here !== problem.goal) {
    const next = lowestNeighbour(here)
    if (next >= 0) tape?.at(lines.choose).write(EVENT.target, next, -1, potential[next])
    const isStuck = next < 0 || (!memory && potential[next] >= potential[here])
    if (isStuck) {
      tape?.at(lines.stuck)
      const place = cellName(width, here)
      return {
        status: memory ? 'dead-end' : 'local-minimum',
        reason: memory
          ? `every legal neighbour of ${place} was visited before`
          : `no legal neighbour of ${place} has a lower potential`,
        path: Int32Array.from(path),
        expanded: 0,
      }
    }
    here = next
    visit(here)
  }
  const reason = 'the agent came down to the goal'
  return { status: 'reached', reason, path: Int32Array.from(path), expanded: 0 }
}
