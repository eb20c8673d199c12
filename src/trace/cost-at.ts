import { isDiagonal, stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import { arrivalIn } from './cell-state'
import { EVENT } from './events'
import type { Frame } from './frame'
import type { Tape } from './tape'

/** Whether an event closes a cell, and its cost is not on the tape. */
const isUntold = (tape: Tape, event: number): boolean =>
  tape.kind(event) === EVENT.close && tape.other(event) >= 0

/** The cost that a search had at an event that opens or closes a cell, not later than `frame`. */
export const costAt = (tape: Tape, frame: Frame, event: number): number =>
  isUntold(tape, event) ? costOfWay(tape, frame, tape.cell(event)) : tape.value(event)

/** The cost of the way by which a search over cells came to a cell, step by step back to where it began. */
export function costOfWay(tape: Tape, { cells, root }: Frame, cell: Cell): number {
  const offsets = stepOffsets(tape.width)
  let straight = 0
  let diagonal = 0
  // A tape of no search at all may lead in circles, or off the map.
  for (let at = cell; at !== root && straight + diagonal < cells.length; ) {
    const direction = arrivalIn(cells[at])
    if (isDiagonal(direction)) diagonal++
    else straight++
    at -= offsets[direction]
  }
  return straight + diagonal * tape.diagonalCost
}
