import type { Cell } from '../grid/grid'
import type { Tape } from './tape'

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

/** How a search reckons what is left from a cell: the simplest path to `goal`. */
export interface Estimate {
  readonly goal: Cell
  /** The planner's variable that is the cost of the latest closed cell and what is left from it. */
  readonly variable: number
}

/** Cells in their order. Those of a frame that came from a worker are packed, and get no more. */
export type CellList = Cell[] | Int32Array

/** Cells in their order, to be read only. */
export type Cells = ArrayLike<Cell> & Iterable<Cell>

/** What the rover knows of a cell. */
export const KNOWN = { unknown: 0, free: 1, obstacle: 2 } as const

/** Where in a cell's byte stands what: two bits, two bits, one bit. */
export const SEARCH_BITS = 3
export const KNOWN_SHIFT = 2
export const KNOWN_BITS = 3 << KNOWN_SHIFT
export const FELT_BIT = 1 << 4

/** One of SEARCH. */
export const searchOf = ({ cells }: Frame, cell: Cell): number => cells[cell] & SEARCH_BITS

/** One of KNOWN. */
export const knownOf = ({ cells }: Frame, cell: Cell): number =>
  (cells[cell] & KNOWN_BITS) >> KNOWN_SHIFT

/** Whether the rover felt the obstacle in a cell. */
export const isFelt = ({ cells }: Frame, cell: Cell): boolean => (cells[cell] & FELT_BIT) !== 0

/**
 * The picture after the first `time` events of a tape. Events only add ink, so any frame is a fold
 * from the start; what is transient (the rover's place, the target) is the latest of its kind.
 */
export interface Frame {
  time: number
  /** Which of the planner's phases it is in; -1 before the first. */
  phase: number
  /**
   * For each cell what the search and the rover know of it, in one byte, because a large map has
   * millions of them: read it with `searchOf`, `knownOf` and `isFelt`.
   */
  readonly cells: Uint8Array
  /** How many cells are open and closed, and the latest cost of one. */
  open: number
  closed: number
  cost: number
  /** Null in a search that reckons nothing. */
  estimate: Estimate | null
  /** How many rows of the map were made vertices of its graph. */
  rows: number
  /** The values of each field, NaN where there is none yet, and the field that was written last. */
  readonly fields: Record<Field, Float64Array | null>
  field: Field | null
  /** The latest test for a corner, and the latest pair of vertices that got no edge. */
  test: Test | null
  refusal: Refusal | null
  /** Of these there may be millions: each list begins its buffer, and `LongList` adds to it. */
  vertices: Int32Array
  /** Pairs of cells, one after the other. */
  edges: Int32Array
  readonly mLine: CellList
  readonly hits: CellList
  readonly leaves: CellList
  /** Cells walked by the rover or the agent, and the path found by a search. */
  readonly trail: CellList
  readonly path: CellList
  /** Nodes of the local tangent graph; it counts until an obstacle stops the rover or is left. */
  readonly nodes: CellList
  /** -1 while there is none; felt obstacle cells apart, `atSide` is the one at the rover's side now. */
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

export function firstFrame({ width, height }: Tape): Frame {
  const cells = width * height
  return {
    time: 0,
    phase: -1,
    cells: new Uint8Array(cells),
    open: 0,
    closed: 0,
    cost: 0,
    estimate: null,
    rows: 0,
    fields: { attraction: null, repulsion: null, potential: null },
    field: null,
    test: null,
    refusal: null,
    vertices: new Int32Array(0),
    edges: new Int32Array(0),
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

/** A frame of its own that shows the same, and to which events may be added. */
export function copyOf(frame: Frame): Frame {
  const { attraction, repulsion, potential } = frame.fields
  const fields = {
    attraction: attraction?.slice() ?? null,
    repulsion: repulsion?.slice() ?? null,
    potential: potential?.slice() ?? null,
  }
  return {
    ...frame,
    cells: frame.cells.slice(),
    fields,
    mLine: unpacked(frame.mLine),
    hits: unpacked(frame.hits),
    leaves: unpacked(frame.leaves),
    trail: unpacked(frame.trail),
    path: unpacked(frame.path),
    nodes: unpacked(frame.nodes),
    values: frame.values.slice(),
  }
}

/** Written out: `Array.from` takes many times as long for millions of cells. */
function unpacked(list: CellList): Cell[] {
  if (Array.isArray(list)) return list.slice()
  const cells: Cell[] = []
  for (let i = 0; i < list.length; i++) cells.push(list[i])
  return cells
}

/** The same frame with its lists packed: many cells are handed over without a copy. */
export function packed(frame: Frame): Frame {
  return {
    ...frame,
    mLine: new Int32Array(frame.mLine),
    hits: new Int32Array(frame.hits),
    leaves: new Int32Array(frame.leaves),
    trail: new Int32Array(frame.trail),
    path: new Int32Array(frame.path),
    nodes: new Int32Array(frame.nodes),
  }
}
