import { directionOf, stepOffsets } from '../grid/directions'
import { type Cell, cellName } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { legalSteps, obstaclesAround } from '../grid/steps'
import { EVENT, type EventKind } from '../trace/events'
import type { Tape } from '../trace/tape'
import type { Answer } from './planner'
import type { Fields } from './potential'
import { pseudocode } from './pseudocode'

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

const HERE = 0
const LOWEST = 1

/** What both planners share of their declarations. */
export const descentPhases = ['Attraction', 'Repulsion', 'Sum of both', 'Walk'] as const
export const descentVariables = ['potential here', 'lowest potential to choose from'] as const

type PotentialLines = ReturnType<typeof descentPseudocode>['line']

export function descentPseudocode(own: Readonly<Record<'choose' | 'step' | 'stuck', string>>) {
  return pseudocode({
    attraction: 'attraction ← (x − xg)² + (y − yg)², for every free cell',
    repulsion:
      'repulsion ← value / distance to the closest obstacle, where one lies within influence',
    sum: 'potential ← attraction + repulsion; infinite for obstacles',
    choose: `while not at the goal: look for ${own.choose}`,
    step: own.step,
    stuck: own.stuck,
  })
}

interface Descent {
  readonly problem: Problem
  readonly fields: Fields
  /** Whether cells already visited are closed to the agent, and steps upwards open to it. */
  readonly memory: boolean
  readonly lines: PotentialLines
  readonly tape: Tape | undefined
}

/** Steps to the legal neighbour with the lowest potential until the goal is reached or none is left. */
export function descend(task: Descent): Answer {
  const { problem, fields, memory, lines, tape } = task
  const { potential } = fields
  const { grid, diagonal } = problem
  const offsets = stepOffsets(grid.width)
  const visited = new Uint8Array(grid.walls.length)
  const path: Cell[] = []
  const visit = (cell: Cell): void => {
    tape?.write(EVENT.step, cell, path.at(-1))
    tape?.write(EVENT.value, cell, HERE, potential(cell))
    path.push(cell)
    visited[cell] = 1
  }
  const lowestNeighbour = (cell: Cell): Cell => {
    const legal = legalSteps(diagonal, obstaclesAround(grid, cell))
    let lowest = -1
    for (const d of ORDER) {
      const next = cell + offsets[d]
      if (((legal >> d) & 1) === 0 || (memory && visited[next])) continue
      if (lowest < 0 || potential(next) < potential(lowest)) lowest = next
    }
    return lowest
  }

  if (tape) recordFields(fields, lines, tape)
  tape?.at(lines.choose).write(EVENT.phase, -1, 3)
  let here = problem.start
  visit(here)
  while (here !== problem.goal) {
    const next = lowestNeighbour(here)
    if (next >= 0) {
      tape?.at(lines.choose).write(EVENT.target, next, -1, potential(next))
      tape?.write(EVENT.value, next, LOWEST, potential(next))
    } else tape?.write(EVENT.value, here, LOWEST, -1)
    const isStuck = next < 0 || (!memory && potential(next) >= potential(here))
    if (isStuck) {
      tape?.at(lines.stuck)
      const place = cellName(grid.width, here)
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
    tape?.at(lines.step)
    visit(here)
  }
  tape?.at(lines.choose)
  const reason = 'the agent came down to the goal'
  return { status: 'reached', reason, path: Int32Array.from(path), expanded: 0 }
}

function recordFields(fields: Fields, lines: PotentialLines, tape: Tape): void {
  const attraction = fields.attraction()
  const repulsion = fields.repulsion()
  recordField(0, lines.attraction, EVENT.attraction, attraction, tape)
  recordField(1, lines.repulsion, EVENT.repulsion, repulsion, tape)
  const potential = attraction
  for (let cell = 0; cell < potential.length; cell++) potential[cell] += repulsion[cell]
  recordField(2, lines.sum, EVENT.potential, potential, tape)
}

function recordField(
  phase: number,
  line: number,
  kind: EventKind,
  field: Float64Array,
  tape: Tape,
): void {
  tape.at(line).write(EVENT.phase, -1, phase)
  for (let cell = 0; cell < field.length; cell++) tape.write(kind, cell, -1, field[cell])
}
