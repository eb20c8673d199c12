import type { Cell } from '../grid/grid'
import { EVENT } from './events'
import type { TapeColumns } from './tape'

/** What the planner knows of one cell at one moment. `null` and empty lists: nothing so far. */
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

type Writable<T> = { -readonly [Name in keyof T]: T[Name] }

/** Reads a tape up to the moment after its first `time` events, for what it tells of `cell`. */
export function cellFacts(tape: TapeColumns, time: number, cell: Cell): CellFacts {
  const { kinds, cells, others, values, width } = tape
  const hits: number[] = []
  const leaves: number[] = []
  const visits: number[] = []
  const facts: Writable<CellFacts> = {
    isVertex: false,
    edges: 0,
    search: null,
    cost: null,
    parent: null,
    attraction: null,
    repulsion: null,
    potential: null,
    sensed: null,
    isFelt: false,
    visits,
    onMLine: null,
    onPath: null,
    hits,
    leaves,
    node: null,
  }
  const row = cell - (cell % width)
  const end = Math.min(time, tape.length)
  let steps = 0
  let mLine = 0
  let path = 0
  for (let i = 0; i < end; i++) {
    const isHere = cells[i] === cell
    switch (kinds[i]) {
      case EVENT.row:
        if (cells[i] === row) facts.isVertex = true
        break
      case EVENT.vertex:
        if (isHere) facts.isVertex = true
        break
      case EVENT.edge:
        if (isHere || others[i] === cell) facts.edges++
        break
      case EVENT.open:
        if (!isHere) break
        facts.search = 'open'
        facts.cost = values[i]
        facts.parent = others[i]
        break
      case EVENT.close:
        if (!isHere) break
        facts.search = 'closed'
        facts.cost = values[i]
        break
      case EVENT.path:
        if (isHere) facts.onPath = path
        path++
        break
      case EVENT.attraction:
        if (isHere) facts.attraction = values[i]
        break
      case EVENT.repulsion:
        if (isHere) facts.repulsion = values[i]
        break
      case EVENT.potential:
        if (isHere) facts.potential = values[i]
        break
      case EVENT.step:
        if (isHere) visits.push(steps)
        steps++
        break
      case EVENT.sense:
        if (isHere) facts.sensed = { isObstacle: others[i] === 1, walked: Math.max(0, steps - 1) }
        break
      case EVENT.mLine:
        if (isHere) facts.onMLine = mLine
        mLine++
        break
      case EVENT.hit:
        if (isHere) hits.push(values[i])
        facts.node = null
        break
      case EVENT.leave:
        if (isHere) leaves.push(values[i])
        facts.node = null
        break
      case EVENT.feel:
        if (isHere) facts.isFelt = true
        break
      case EVENT.scan:
        facts.node = null
        break
      case EVENT.node:
        if (isHere) facts.node = values[i]
        break
    }
  }
  return facts
}
