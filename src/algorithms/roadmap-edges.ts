import { stepOffsets } from '../grid/directions'
import { type Cell, pointOf } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'
import { simplestStep } from '../grid/simplest-path'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { type Cost, costOfWeight, simplestPathWeights } from './costs'
import { isOutward, otherEnd, type Roadmap, roomForEdges } from './roadmap'

/** With more vertices the pairs without an edge are too many to show one by one. */
const MOST_VERTICES_WITH_REFUSALS = 256

/** With more edges a tape would not fit into memory; the search uses all of them all the same. */
const MOST_EDGES = 2_000_000

const REFUSED = 0
const OUTWARD = 1
const INWARD = 2

/**
 * Writes down every edge of a roadmap, from the cell whose simplest path to the other is free. On
 * small roadmaps the pairs that get no edge are written down too, with the cell where the simplest
 * path from the first one is refused; on huge ones the tape is cut.
 */
export function recordEdges(
  roadmap: Roadmap,
  problem: Problem,
  cost: Cost,
  tape: Tape,
  progress: (done: number) => void,
): void {
  const { vertices } = roadmap
  const firstRefusal = refusals(problem)
  const withRefusals = vertices.length <= MOST_VERTICES_WITH_REFUSALS
  const pairs = new Uint8Array(vertices.length)
  const joined: number[] = []
  const edges = roomForEdges(roadmap)
  const weigh = simplestPathWeights(cost, problem.grid.width)
  tape.write(EVENT.phase, -1, 1)
  const before = tape.length
  for (let vertex = 0; vertex < vertices.length; vertex++) {
    const from = vertices[vertex]
    if (vertex % 64 === 0) progress(vertex / vertices.length)
    if (tape.length - before > MOST_EDGES) {
      tape.write(EVENT.cut, from, -1, tape.length - before)
      return
    }
    joined.length = 0
    const count = roadmap.edgesOf(vertex, edges)
    for (let i = 0; i < count; i++) {
      const other = otherEnd(edges[i])
      if (other <= vertex || pairs[other] !== REFUSED) continue
      pairs[other] = isOutward(edges[i]) ? OUTWARD : INWARD
      joined.push(other)
    }
    if (withRefusals) {
      joined.length = 0
      for (let other = vertex + 1; other < vertices.length; other++) joined.push(other)
    }
    for (const other of joined) {
      const to = vertices[other]
      if (pairs[other] === REFUSED) tape.write(EVENT.refuse, from, to, firstRefusal(from, to))
      else {
        const weight = costOfWeight(cost, weigh(from, to))
        if (pairs[other] === OUTWARD) tape.write(EVENT.edge, from, to, weight)
        else tape.write(EVENT.edge, to, from, weight)
      }
      pairs[other] = REFUSED
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
