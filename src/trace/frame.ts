import type { Cell } from '../grid/grid'
import { isFeltIn, knownIn, searchIn } from './cell-state'
import type { Tape } from './tape'

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

/** The estimate of a search like A*: from each cell the cost of the simplest path to `goal` is left. */
export interface Estimate {
  readonly goal: Cell
  /** The planner's variable that is the sum of the latest closed cell's cost and its estimate. */
  readonly variable: number
}

/** Cells in their order. Those of a frame that came from a worker are packed, and get no more. */
export type CellList = Cell[] | Int32Array

/** Cells in their order, to be read only. */
export type Cells = ArrayLike<Cell> & Iterable<Cell>

/**
 * The picture after the first `time` events of a tape. Events only add ink, so any frame is a fold
 * from the start; what is transient (the rover's place, the target) is the latest of its kind.
 */
export interface Frame {
  time: number
  /** Which of the planner's phases it is in; -1 before the first. */
  phase: number
  /** The state of each cell: read it with `searchOf`, `knownOf` and `isFelt`. */
  readonly cells: Uint8Array
  /** How many cells are open and closed, and the latest cost of one. */
  open: number
  closed: number
  cost: number
  /** The numbers of the latest event that opened or closed a cell, and of the latest that closed one. */
  searchedBy: number
  closedBy: number
  /** The cell that was closed first: there begin the ways of a search. */
  root: Cell
  /** Null in a search without an estimate. */
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
  /** Whether there are more edges than these, which the tape leaves out. */
  edgesCut: boolean
  readonly mLine: CellList
  readonly hits: CellList
  readonly leaves: CellList
  /** Cells walked by the rover or the agent, and the path found by a search. */
  readonly trail: CellList
  readonly path: CellList
  /** Nodes of the latest local tangent graph, until an obstacle stops the rover or is left. */
  readonly nodes: CellList
  /** Where the rover or the agent is, and where it heads; -1 while there is none. */
  rover: Cell
  target: Cell
  /** The obstacle cell at the rover's side now; -1 while there is none. */
  atSide: Cell
  /** Whether it follows a boundary, and on which side the obstacle is: 0 left, 1 right. */
  following: boolean
  turn: number
  /** Latest value of each of the planner's variables. */
  readonly values: number[]
  /** The line of the pseudocode of the latest event; -1 at the start. */
  line: number
}

/** What the search knows of a cell: one of SEARCH. */
export const searchOf = ({ cells }: Frame, cell: Cell): number => searchIn(cells[cell])

/** What the rover knows of a cell: one of KNOWN. */
export const knownOf = ({ cells }: Frame, cell: Cell): number => knownIn(cells[cell])

/** Whether the rover felt the obstacle in a cell. */
export const isFelt = ({ cells }: Frame, cell: Cell): boolean => isFeltIn(cells[cell])

/** The frame before the first event. */
export function firstFrame({ width, height }: Tape): Frame {
  const cells = width * height
  return {
    time: 0,
    phase: -1,
    cells: new Uint8Array(cells),
    open: 0,
    closed: 0,
    cost: 0,
    searchedBy: -1,
    closedBy: -1,
    root: -1,
    estimate: null,
    rows: 0,
    fields: { attraction: null, repulsion: null, potential: null },
    field: null,
    test: null,
    refusal: null,
    vertices: new Int32Array(0),
    edges: new Int32Array(0),
    edgesCut: false,
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

/** A copy of a frame, to which events may be added: nothing but `vertices` and `edges` is shared. */
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
