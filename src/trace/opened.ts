import { isDiagonal, stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import { EVENT } from './events'
import type { Tape } from './tape'

/** A neighbour of a cell that is closed, and the cost of the step to it. */
export interface Opened {
  readonly cell: Cell
  readonly step: number
}

/**
 * The neighbours that become open, or get a shorter way, with an event that closes a cell; in the
 * order in which a search over cells looks at them.
 */
export function openedBy(tape: Tape, event: number): Opened[] {
  const directions = tape.kind(event) === EVENT.close ? tape.other(event) : 0
  const opened: Opened[] = []
  if (directions <= 0) return opened
  const offsets = stepOffsets(tape.width)
  for (let d = 7; d >= 0; d--) {
    if (((directions >> d) & 1) === 0) continue
    const step = isDiagonal(d) ? tape.diagonalCost : 1
    opened.push({ cell: tape.cell(event) + offsets[d], step })
  }
  return opened
}
