import type { Cell } from '../grid/grid'
import { KNOWN, SEARCH } from './cell-state'
import { costAt, costOfWay } from './cost-at'
import { EVENT, type EventKind } from './events'
import { type CellList, type Frame, isFelt, knownOf, searchOf } from './frame'
import { openedBy } from './opened'
import type { Tape } from './tape'

/** What the planner knows of one cell at one moment; `null` or an empty list where it is nothing. */
export interface CellFacts {
  /** Whether it is a vertex of the graph; of a grid's graph, whether its row is part of it. */
  readonly isVertex: boolean
  /** Edges of the roadmap that end here. */
  readonly edges: number
  readonly search: 'open' | 'closed' | null
  /** The cost of the way to it that is known, and the cell or vertex before it; -1 for the start. */
  readonly cost: number | null
  readonly parent: Cell | null
  readonly attraction: number | null
  readonly repulsion: number | null
  readonly potential: number | null
  /** What the sensor saw, and how many steps the rover had walked by then. */
  readonly sensed: { readonly isObstacle: boolean; readonly walked: number } | null
  /** Whether the rover keeps or kept this obstacle cell at its side. */
  readonly isFelt: boolean
  /** How many steps the rover or the agent had walked each time that it stood here. */
  readonly visits: readonly number[]
  /** Its place on the m-line and on the path that was found, counted from 0. */
  readonly onMLine: number | null
  readonly onPath: number | null
  /** Numbers of the hit points and of the leave points here. */
  readonly hits: readonly number[]
  readonly leaves: readonly number[]
  /** The distance over it to the goal, if it is a node of the present local tangent graph. */
  readonly node: number | null
}

/**
 * What a tape tells of `cell` up to the moment of `frame`. Most of it stands in the frame. What does
 * not is looked for on the tape, which may be long, only if the frame says that it is there.
 */
export function cellFacts(tape: Tape, frame: Frame, cell: Cell): CellFacts {
  const { attraction, repulsion, potential } = frame.fields
  const { rows, vertices, trail, mLine, path, hits, leaves, nodes } = frame
  const row = Math.floor(cell / tape.width)
  const numbers = (list: CellList, kind: EventKind) =>
    list.includes(cell) ? eventsAt(tape, frame.time, cell, kind).map((i) => tape.value(i)) : []
  const isOnRoadmap = vertices.includes(cell)
  return {
    isVertex: row < rows || isOnRoadmap,
    edges: isOnRoadmap ? placesOf(frame.edges, cell).length : 0,
    ...searchAt(tape, frame, cell),
    attraction: valueAt(attraction, cell),
    repulsion: valueAt(repulsion, cell),
    potential: valueAt(potential, cell),
    sensed: sensedAt(tape, frame, cell),
    isFelt: isFelt(frame, cell),
    visits: placesOf(trail, cell),
    onMLine: placesOf(mLine, cell).at(-1) ?? null,
    onPath: placesOf(path, cell).at(-1) ?? null,
    hits: numbers(hits, EVENT.hit),
    leaves: numbers(leaves, EVENT.leave),
    node: numbers(nodes, EVENT.node).at(-1) ?? null,
  }
}

function placesOf(list: CellList, cell: Cell): number[] {
  const places: number[] = []
  for (let i = list.indexOf(cell); i >= 0; i = list.indexOf(cell, i + 1)) places.push(i)
  return places
}

const valueAt = (field: Float64Array | null, cell: Cell): number | null =>
  field === null || Number.isNaN(field[cell]) ? null : field[cell]

/** The latest event of a kind at a cell before `time`; -1 if there is none. */
const latestAt = (tape: Tape, time: number, cell: Cell, kind: EventKind): number =>
  tape.findLast(time, cell, 0, (i) => tape.kind(i) === kind)

/** All events of a kind at a cell before `time`, in their order. */
function eventsAt(tape: Tape, time: number, cell: Cell, kind: EventKind): number[] {
  const events: number[] = []
  for (let i = latestAt(tape, time, cell, kind); i >= 0; i = latestAt(tape, i, cell, kind)) {
    events.push(i)
  }
  return events.reverse()
}

function searchAt(
  tape: Tape,
  frame: Frame,
  cell: Cell,
): Pick<CellFacts, 'search' | 'cost' | 'parent'> {
  const search = searchOf(frame, cell)
  if (search === SEARCH.untouched) return { search: null, cost: null, parent: null }
  if (search === SEARCH.open) return { search: 'open', ...wayTo(tape, frame, frame.time, cell) }
  const closed = latestAt(tape, frame.time, cell, EVENT.close)
  // Vertices of a roadmap are opened by events that a thinned tape leaves out: do not look for them.
  const isTold = tape.thinning === 'whole' || frame.vertices.length === 0
  const parent = isTold ? wayTo(tape, frame, closed, cell).parent : null
  return { search: 'closed', cost: costAt(tape, frame, closed), parent }
}

/** The way by which a cell was last reached before `time`. A thinned tape does not always have it. */
function wayTo(
  tape: Tape,
  frame: Frame,
  time: number,
  cell: Cell,
): Pick<CellFacts, 'cost' | 'parent'> {
  const isOver = (i: number) => openedBy(tape, i).some((opened) => opened.cell === cell)
  // A cell that opens its neighbours is one row away at most.
  const i = tape.findLast(time, cell, tape.width + 1, (event) =>
    tape.kind(event) === EVENT.open ? tape.cell(event) === cell : isOver(event),
  )
  if (i < 0) return { cost: null, parent: null }
  return tape.kind(i) === EVENT.open
    ? { cost: tape.value(i), parent: tape.other(i) }
    : { cost: costOfWay(tape, frame, cell), parent: tape.cell(i) }
}

function sensedAt(tape: Tape, frame: Frame, cell: Cell): CellFacts['sensed'] {
  const known = knownOf(frame, cell)
  if (known === KNOWN.unknown) return null
  const sensed = latestAt(tape, frame.time, cell, EVENT.sense)
  let steps = 0
  for (let i = 0; i < sensed; i++) if (tape.kind(i) === EVENT.step) steps++
  return { isObstacle: known === KNOWN.obstacle, walked: Math.max(0, steps - 1) }
}
