import type { Cell } from '../grid/grid'
import { EVENT } from './events'
import type { TapeColumns } from './tape'

/** What the search knows of a cell. */
export const SEARCH = { untouched: 0, open: 1, closed: 2 } as const

/** What the rover knows of a cell. */
export const KNOWN = { unknown: 0, free: 1, obstacle: 2 } as const

/**
 * The picture after the first `time` events of a tape. Events only add ink, so any frame is a fold
 * from the start; what is transient (the rover's place, the target) is the latest of its kind.
 */
export interface Frame {
  time: number
  /** For each cell one of SEARCH, one of KNOWN, whether the rover felt it, its potential (or NaN). */
  readonly search: Uint8Array
  readonly known: Uint8Array
  readonly felt: Uint8Array
  potential: Float64Array | null
  readonly vertices: Cell[]
  /** Pairs of cells, one after the other. */
  readonly edges: Cell[]
  readonly mLine: Cell[]
  readonly hits: Cell[]
  readonly leaves: Cell[]
  /** Cells walked by the rover or the agent, and the path found by a search. */
  readonly trail: Cell[]
  readonly path: Cell[]
  /** -1 while there is none. */
  rover: Cell
  target: Cell
  /** Latest value of each of the planner's variables. */
  readonly values: number[]
  /** The line of the pseudocode of the latest event; -1 at the start. */
  line: number
}

export function firstFrame({ width, height }: TapeColumns): Frame {
  const cells = width * height
  return {
    time: 0,
    search: new Uint8Array(cells),
    known: new Uint8Array(cells),
    felt: new Uint8Array(cells),
    potential: null,
    vertices: [],
    edges: [],
    mLine: [],
    hits: [],
    leaves: [],
    trail: [],
    path: [],
    rover: -1,
    target: -1,
    values: [],
    line: -1,
  }
}

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
  switch (tape.kinds[i]) {
    case EVENT.open:
      frame.search[cell] = SEARCH.open
      break
    case EVENT.close:
      frame.search[cell] = SEARCH.closed
      break
    case EVENT.vertex:
      frame.vertices.push(cell)
      break
    case EVENT.edge:
      frame.edges.push(cell, tape.others[i])
      break
    case EVENT.potential:
      frame.potential ??= new Float64Array(frame.search.length).fill(Number.NaN)
      frame.potential[cell] = tape.values[i]
      break
    case EVENT.sense:
      frame.known[cell] = tape.others[i] ? KNOWN.obstacle : KNOWN.free
      break
    case EVENT.step:
      frame.trail.push(cell)
      frame.rover = cell
      break
    case EVENT.hit:
      frame.hits.push(cell)
      break
    case EVENT.leave:
      frame.leaves.push(cell)
      break
    case EVENT.feel:
      if (cell >= 0) frame.felt[cell] = 1
      break
    case EVENT.mLine:
      frame.mLine.push(cell)
      break
    case EVENT.target:
      frame.target = cell
      break
    case EVENT.value:
      frame.values[tape.others[i]] = tape.values[i]
      break
    case EVENT.path:
      frame.path.push(cell)
      break
  }
}
