import type { Cell } from '../grid/grid'
import { EVENT } from './events'
import {
  FELT_BIT,
  type Field,
  type Frame,
  firstFrame,
  KNOWN,
  KNOWN_BITS,
  KNOWN_SHIFT,
  SEARCH,
  SEARCH_BITS,
} from './frame'
import type { TapeColumns } from './tape'

/** Folds the events from `frame.time` up to `time` into the frame. */
export function advance(frame: Frame, tape: TapeColumns, time: number): void {
  const end = Math.min(time, tape.length)
  for (let i = frame.time; i < end; i++) fold(frame, tape, i)
  if (end > 0) frame.line = tape.lines[end - 1]
  frame.time = end
}

/** The frame after the first `time` events; all of them if `time` is larger. */
export function frameAt(tape: TapeColumns, time: number): Frame {
  const frame = firstFrame(tape)
  advance(frame, tape, time)
  return frame
}

function fold(frame: Frame, tape: TapeColumns, i: number): void {
  const cell = tape.cells[i]
  const other = tape.others[i]
  const value = tape.values[i]
  switch (tape.kinds[i]) {
    case EVENT.phase:
      frame.phase = other
      frame.test = null
      frame.refusal = null
      break
    case EVENT.row:
      frame.rows++
      break
    case EVENT.test:
      frame.test = { cell, obstacle: other, passed: value === 1 }
      break
    case EVENT.vertex:
      frame.vertices.push(cell)
      break
    case EVENT.edge:
      frame.edges.push(cell, other)
      frame.refusal = null
      break
    case EVENT.refuse:
      frame.refusal = { from: cell, to: other, at: value }
      break
    case EVENT.open:
      search(frame, cell, SEARCH.open)
      frame.cost = value
      break
    case EVENT.close:
      search(frame, cell, SEARCH.closed)
      frame.cost = value
      break
    case EVENT.path:
      frame.path.push(cell)
      break
    case EVENT.attraction:
      fieldOf(frame, 'attraction')[cell] = value
      break
    case EVENT.repulsion:
      fieldOf(frame, 'repulsion')[cell] = value
      break
    case EVENT.potential:
      fieldOf(frame, 'potential')[cell] = value
      break
    case EVENT.step:
      frame.trail.push(cell)
      frame.rover = cell
      break
    case EVENT.sense:
      sense(frame.cells, cell, other ? KNOWN.obstacle : KNOWN.free)
      break
    case EVENT.target:
      frame.target = cell
      // Who heads for a place goes straight there, or back along a boundary.
      frame.atSide = -1
      break
    case EVENT.mLine:
      frame.mLine.push(cell)
      break
    case EVENT.hit:
      frame.hits.push(cell)
      frame.following = true
      frame.target = -1
      frame.nodes.length = 0
      break
    case EVENT.turn:
      frame.turn = other
      break
    case EVENT.feel:
      frame.atSide = cell
      if (cell >= 0) frame.cells[cell] |= FELT_BIT
      break
    case EVENT.leave:
      frame.leaves.push(cell)
      frame.following = false
      frame.target = -1
      frame.nodes.length = 0
      break
    case EVENT.scan:
      frame.nodes.length = 0
      break
    case EVENT.node:
      frame.nodes.push(cell)
      break
    case EVENT.value:
      frame.values[other] = value
      break
  }
}

/** A cell is open or closed; on a thinned tape it may be closed without ever having been opened. */
function search(frame: Frame, cell: Cell, now: number): void {
  const { cells } = frame
  const before = cells[cell] & SEARCH_BITS
  if (before === SEARCH.open) frame.open--
  else if (before === SEARCH.closed) frame.closed--
  if (now === SEARCH.open) frame.open++
  else frame.closed++
  cells[cell] = (cells[cell] & ~SEARCH_BITS) | now
}

function sense(cells: Uint8Array, cell: Cell, known: number): void {
  cells[cell] = (cells[cell] & ~KNOWN_BITS) | (known << KNOWN_SHIFT)
}

function fieldOf(frame: Frame, field: Field): Float64Array {
  frame.field = field
  frame.fields[field] ??= new Float64Array(frame.cells.length).fill(Number.NaN)
  return frame.fields[field]
}
