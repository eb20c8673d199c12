import { stepOffsets } from '../grid/directions'
import { type Cell, pointOf } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'
import { simplestPathCost, simplestStep } from '../grid/simplest-path'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { type Cost, diagonalCost } from './costs'
import type { Outward } from './sight/rays'
import type { Sight } from './sight/sight'

/** With more vertices the pairs without an edge are too many to show one by one. */
const MOST_VERTICES_WITH_REFUSALS = 256

/** With more edges a tape would not fit into memory; the search uses all of them all the same. */
const MOST_EDGES = 2_000_000

const REFUSED = 0
const OUTWARD = 1
const INWARD = 2
/** All pairs of this vertex were looked at. */
const DONE = 3

/**
 * Writes down every edge of a roadmap, from the cell whose simplest path to the other is free. On
 * small roadmaps the pairs that get no edge are written down too, with the cell where the simplest
 * path from the first one is refused; on huge ones the tape is cut.
 */
export function recordEdges(
  vertices: Int32Array,
  sight: Sight,
  problem: Problem,
  cost: Cost,
  tape: Tape,
  progress: (done: number) => void,
): void {
  const firstRefusal = refusals(problem)
  const withRefusals = vertices.length <= MOST_VERTICES_WITH_REFUSALS
  /** How each vertex is joined to the one whose turn it is. */
  const joins = new Uint8Array(problem.grid.walls.length)
  const joined: Cell[] = []
  const { width } = problem.grid
  const diagonal = diagonalCost(cost)
  const join = (vertex: Cell, outward: Outward): void => {
    if (joins[vertex] !== REFUSED) return
    joins[vertex] = outward ? OUTWARD : INWARD
    joined.push(vertex)
  }
  tape.write(EVENT.phase, -1, 1)
  const before = tape.length
  for (let i = 0; i < vertices.length; i++) {
    const from = vertices[i]
    if (i % 64 === 0) progress(i / vertices.length)
    if (tape.length - before > MOST_EDGES) {
      tape.write(EVENT.cut, from, -1, tape.length - before)
      return
    }
    joins[from] = DONE
    joined.length = 0
    sight.all(from, join)
    for (const to of withRefusals ? vertices.subarray(i + 1) : joined) {
      if (joins[to] === REFUSED) tape.write(EVENT.refuse, from, to, firstRefusal(from, to))
      else {
        const length = simplestPathCost(from, to, width, diagonal)
        if (joins[to] === OUTWARD) tape.write(EVENT.edge, from, to, length)
        else tape.write(EVENT.edge, to, from, length)
      }
      joins[to] = REFUSED
    }
  }
}

/** Finds the cell that the first refused step of a simplest path leads to; -1 if there is none. */
function refusals({ grid, diagonal }: Problem): (from: Cell, to: Cell) => Cell {
  const legal = allLegalSteps(grid, diagonal)
  const offsets = stepOffsets(grid.width)
  return (from, to) => {
    const end = pointOf(grid.width, to)
    for (let cell = from; cell !== to; ) {
      const direction = simplestStep(pointOf(grid.width, cell), end)
      const next = cell + offsets[direction]
      if (((legal[cell] >> direction) & 1) === 0) return next
      cell = next
    }
    return -1
  }
}
