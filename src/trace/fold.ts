import { stepOffsets } from '../grid/directions'
import { InputError } from '../grid/errors'
import type { Cell } from '../grid/grid'
import type { Directions } from '../grid/steps'
import { KNOWN, SEARCH, searchIn, withArrival, withFelt, withKnown, withSearch } from './cell-state'
import { costAt } from './cost-at'
import { costLeft } from './cost-left'
import { EVENT } from './events'
import { type CellList, type Field, type Frame, firstFrame } from './frame'
import { LongList } from './long-list'
import type { Tape } from './tape'

/** Folds the events from `frame.time` up to `time` into the frame. */
export function advance(frame: Frame, tape: Tape, time: number): void {
  const end = Math.min(time, tape.length)
  const offsets = stepOffsets(tape.width)
  const vertices = new LongList(frame.vertices)
  const edges = new LongList(frame.edges)
  for (let i = frame.time; i < end; i++) fold(frame, tape, i, offsets, vertices, edges)
  frame.vertices = vertices.cells
  frame.edges = edges.cells
  if (end > 0) frame.line = tape.line(end - 1)
  frame.time = end
  reckon(frame, tape)
}

/** Numbers that are not on the tape, and wanted at the end only. */
function reckon(frame: Frame, tape: Tape): void {
  const { searchedBy, closedBy, estimate } = frame
  if (searchedBy >= 0) frame.cost = costAt(tape, frame, searchedBy)
  if (estimate && closedBy >= 0) {
    const left = costLeft(tape, tape.cell(closedBy), estimate.goal)
    frame.values[estimate.variable] = costAt(tape, frame, closedBy) + left
  }
}

/**
 * The frame after the first `time` events; all of them if `time` is larger.
 * @throws InputError if `time` is not a whole number from 0
 */
export function frameAt(tape: Tape, time: number): Frame {
  if (!(time >= 0) || time % 1 > 0) {
    throw new InputError(`The moment ${time} is not a whole number from 0.`)
  }
  const frame = firstFrame(tape)
  advance(frame, tape, time)
  return frame
}

function fold(
  frame: Frame,
  tape: Tape,
  i: number,
  offsets: Int32Array,
  vertices: LongList,
  edges: LongList,
): void {
  const cell = tape.cell(i)
  const other = tape.other(i)
  const value = tape.value(i)
  switch (tape.kind(i)) {
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
      vertices.push(cell)
      break
    case EVENT.edge:
      edges.push(cell)
      edges.push(other)
      frame.refusal = null
      break
    case EVENT.cut:
      frame.edgesCut = true
      break
    case EVENT.refuse:
      frame.refusal = { from: cell, to: other, at: value }
      break
    case EVENT.open:
      search(frame, cell, SEARCH.open)
      frame.searchedBy = i
      break
    case EVENT.close:
      search(frame, cell, SEARCH.closed)
      openNeighbours(frame, cell, other, offsets)
      frame.searchedBy = i
      frame.closedBy = i
      if (frame.root < 0) frame.root = cell
      break
    case EVENT.path:
      push(frame.path, cell)
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
      push(frame.trail, cell)
      frame.rover = cell
      break
    case EVENT.sense:
      frame.cells[cell] = withKnown(frame.cells[cell], other ? KNOWN.obstacle : KNOWN.free)
      break
    case EVENT.target:
      frame.target = cell
      // On its way there, straight or back along a boundary, it keeps no obstacle at its side.
      frame.atSide = -1
      break
    case EVENT.mLine:
      push(frame.mLine, cell)
      break
    case EVENT.hit:
      push(frame.hits, cell)
      frame.following = true
      frame.target = -1
      clear(frame.nodes)
      break
    case EVENT.turn:
      frame.turn = other
      break
    case EVENT.feel:
      frame.atSide = cell
      if (cell >= 0) frame.cells[cell] = withFelt(frame.cells[cell])
      break
    case EVENT.leave:
      push(frame.leaves, cell)
      frame.following = false
      frame.target = -1
      clear(frame.nodes)
      break
    case EVENT.scan:
      clear(frame.nodes)
      break
    case EVENT.node:
      push(frame.nodes, cell)
      break
    case EVENT.estimate:
      frame.estimate = { goal: cell, variable: other }
      break
    case EVENT.value:
      frame.values[other] = value
      break
  }
}

function push(list: CellList, cell: Cell): void {
  if (!Array.isArray(list)) throw new Error('A packed frame gets no more events.')
  list.push(cell)
}

function clear(list: CellList): void {
  if (Array.isArray(list)) list.length = 0
}

/** A cell is open or closed; on a thinned tape it may be closed without ever having been opened. */
function search(frame: Frame, cell: Cell, now: number): void {
  const { cells } = frame
  const before = searchIn(cells[cell])
  if (before === SEARCH.open) frame.open--
  else if (before === SEARCH.closed) frame.closed--
  if (now === SEARCH.open) frame.open++
  else frame.closed++
  cells[cell] = withSearch(cells[cell], now)
}

function openNeighbours(frame: Frame, cell: Cell, opened: Directions, offsets: Int32Array): void {
  for (let left = opened; left > 0; ) {
    const direction = 31 - Math.clz32(left)
    left ^= 1 << direction
    const neighbour = cell + offsets[direction]
    search(frame, neighbour, SEARCH.open)
    frame.cells[neighbour] = withArrival(frame.cells[neighbour], direction)
  }
}

function fieldOf(frame: Frame, field: Field): Float64Array {
  frame.field = field
  frame.fields[field] ??= new Float64Array(frame.cells.length).fill(Number.NaN)
  return frame.fields[field]
}
