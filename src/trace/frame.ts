import type { Cell } from '../grid/grid'
import { EVENT } from './events'
import type { TapeColumns } from './tape'

/** What the search knows of a cell. */
export const SEARCH = { untouched: 0, open: 1, closed: 2 } as const

/** The parts of a potential, and their sum. */
export type Field = 'attraction' | 'repulsion' | 'potential'

/** A cell that was tested for being the corner of an obstacle (report, Fig. 4). */
export interface Test {
  readonly cell: Cell
  readonly obstacle: Cell
  readonly passed: boolean
}

/** Two vertices without an edge, and the cell where the simplest path from the first is refused. */
export interface Refusal {
  readonly from: Cell
  readonly to: Cell
  readonly at: Cell
}

/** What the rover knows of a cell. */
export const KNOWN = { unknown: 0, free: 1, obstacle: 2 } as const

/**
 * The picture after the first `time` events of a tape. Events only add ink, so any frame is a fold
 * from the start; what is transient (the rover's place, the target) is the latest of its kind.
 */
export interface Frame {
  time: number
  /** Which of the planner's phases it is in; -1 before the first. */
  phase: number
  /** For each cell one of SEARCH, one of KNOWN, whether the rover felt it. */
  readonly search: Uint8Array
  readonly known: Uint8Array
  readonly felt: Uint8Array
  /** How many cells are open and closed, and the latest cost of one. */
  open: number
  closed: number
  cost: number
  /** How many rows of the map were made vertices of its graph. */
  rows: number
  /** The values of each field, NaN where there is none yet, and the field that was written last. */
  readonly fields: Record<Field, Float64Array | null>
  field: Field | null
  /** The latest test for a corner, and the latest pair of vertices that got no edge. */
  test: Test | null
  refusal: Refusal | null
  readonly vertices: Cell[]
  /** Pairs of cells, one after the other. */
  readonly edges: Cell[]
  readonly mLine: Cell[]
  readonly hits: Cell[]
  readonly leaves: Cell[]
  /** Cells walked by the rover or the agent, and the path found by a search. */
  readonly trail: Cell[]
  readonly path: Cell[]
  /** Nodes of the local tangent graph; it counts until an obstacle stops the rover or is left. */
  readonly nodes: Cell[]
  /** -1 while there is none; `felt` obstacle cells apart, `atSide` is the one at the rover's side now. */
  rover: Cell
  target: Cell
  atSide: Cell
  /** Whether it follows a boundary, and on which side the obstacle is: 0 left, 1 right. */
  following: boolean
  turn: number
  /** Latest value of each of the planner's variables. */
  readonly values: number[]
  /** The line of the pseudocode of the latest event; -1 at the start. */
  line: number
}

export function firstFrame({ width, height }: TapeColumns): Frame {
  const cells = width * height
  return {
    time: 0,
    phase: -1,
    search: new Uint8Array(cells),
    known: new Uint8Array(cells),
    felt: new Uint8Array(cells),
    open: 0,
    closed: 0,
    cost: 0,
    rows: 0,
    fields: { attraction: null, repulsion: null, potential: null },
    field: null,
    test: null,
    refusal: null,
    vertices: [],
    edges: [],
    mLine: [],
    hits: [],
    leaves: [],
    trail: [],
    path: [],
    nodes: [],
    rover: -1,
    target: -1,
    atSide: -1,
    following: false,
    turn: 0,
    values: [],
    line: -1,
  }
}

/** A frame of its own that shows the same. */
export function copyOf(frame: Frame): Frame {
  const { attraction, repulsion, potential } = frame.fields
  const fields = {
    attraction: attraction?.slice() ?? null,
    repulsion: repulsion?.slice() ?? null,
    potential: potential?.slice() ?? null,
  }
  return {
    ...frame,
    search: frame.search.slice(),
    known: frame.known.slice(),
    felt: frame.felt.slice(),
    fields,
    vertices: frame.vertices.slice(),
    edges: frame.edges.slice(),
    mLine: frame.mLine.slice(),
    hits: frame.hits.slice(),
    leaves: frame.leaves.slice(),
    trail: frame.trail.slice(),
    path: frame.path.slice(),
    nodes: frame.nodes.slice(),
    values: frame.values.slice(),
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
      if (frame.search[cell] !== SEARCH.open) frame.open++
      frame.search[cell] = SEARCH.open
      frame.cost = value
      break
    case EVENT.close:
      frame.open--
      frame.closed++
      frame.search[cell] = SEARCH.closed
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
      frame.known[cell] = other ? KNOWN.obstacle : KNOWN.free
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
      if (cell >= 0) frame.felt[cell] = 1
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

function fieldOf(frame: Frame, field: Field): Float64Array {
  frame.field = field
  frame.fields[field] ??= new Float64Array(frame.search.length).fill(Number.NaN)
  return frame.fields[field]
}
