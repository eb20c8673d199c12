import { isDiagonal, stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { allLegalSteps } from '../grid/steps'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'

/** What a search over the cells of a map found. */
export interface GridSearch {
  readonly found: boolean
  /** For each cell the cell before it on its shortest path; -1 if none. */
  readonly parents: Int32Array
  readonly expanded: number
}

/** Where a search writes down what it does. */
export interface SearchNotes {
  readonly tape: Tape | undefined
  readonly openLine: number
  readonly closeLine: number
  readonly progress: (done: number) => void
}

const STEP_LENGTH = Float64Array.from({ length: 8 }, (_, d) => (isDiagonal(d) ? Math.SQRT2 : 1))
const PROGRESS_EVERY = 1 << 16

/**
 * Dijkstra with every step at cost 1: a breadth-first search, one queue. Among paths of equally
 * many steps it keeps one with the fewest diagonal steps. A cell's parents all lie one ring closer
 * to the start, so its count of diagonals is final before it is expanded itself.
 */
export function searchByCells(problem: Problem, notes: SearchNotes): GridSearch {
  const { grid, start, goal, diagonal } = problem
  const { tape, openLine, closeLine } = notes
  const legal = allLegalSteps(grid, diagonal)
  const offsets = stepOffsets(grid.width)
  const count = grid.walls.length
  const rings = new Int32Array(count).fill(-1)
  const diagonals = new Int32Array(count)
  const parents = new Int32Array(count).fill(-1)
  const queue = new Int32Array(count)
  let tail = 1
  queue[0] = start
  rings[start] = 0
  tape?.at(openLine).write(EVENT.open, start)
  for (let head = 0; head < tail; head++) {
    const cell: Cell = queue[head]
    if (tape) tape.at(closeLine).write(EVENT.close, cell, -1, rings[cell])
    if (cell === goal) return { found: true, parents, expanded: head + 1 }
    if (head % PROGRESS_EVERY === 0) notes.progress(head / count)
    const ring = rings[cell] + 1
    for (let steps = legal[cell], d = 0; steps !== 0; steps >>= 1, d++) {
      if ((steps & 1) === 0) continue
      const next = cell + offsets[d]
      const turned = diagonals[cell] + (d & 1)
      if (rings[next] < 0) {
        rings[next] = ring
        queue[tail++] = next
      } else if (rings[next] !== ring || diagonals[next] <= turned) continue
      diagonals[next] = turned
      parents[next] = cell
      if (tape) tape.at(openLine).write(EVENT.open, next, cell, ring)
    }
  }
  return { found: false, parents, expanded: tail }
}

/**
 * Dijkstra with steps of 1 and √2, without a heap: cells wait in buckets one unit of cost wide. No
 * step is shorter than a bucket, so the cells of one bucket cannot improve each other, any order
 * among them is right, and three buckets in turn hold all that wait.
 */
export function searchByLength(problem: Problem, notes: SearchNotes): GridSearch {
  const { grid, start, goal, diagonal } = problem
  const { tape, openLine, closeLine } = notes
  const legal = allLegalSteps(grid, diagonal)
  const offsets = stepOffsets(grid.width)
  const count = grid.walls.length
  const lengths = new Float64Array(count).fill(Number.POSITIVE_INFINITY)
  const parents = new Int32Array(count).fill(-1)
  const closed = new Uint8Array(count)
  const buckets: Cell[][] = [[start], [], []]
  let waiting = 1
  let expanded = 0
  lengths[start] = 0
  tape?.at(openLine).write(EVENT.open, start)
  for (let b = 0; waiting > 0; b++) {
    const bucket = buckets[b % 3]
    for (let i = 0; i < bucket.length; i++) {
      const cell = bucket[i]
      // A cell that was improved stands in an earlier place too.
      if (closed[cell]) continue
      closed[cell] = 1
      if (tape) tape.at(closeLine).write(EVENT.close, cell, -1, lengths[cell])
      if (++expanded % PROGRESS_EVERY === 0) notes.progress(expanded / count)
      if (cell === goal) return { found: true, parents, expanded }
      for (let steps = legal[cell], d = 0; steps !== 0; steps >>= 1, d++) {
        if ((steps & 1) === 0) continue
        const next = cell + offsets[d]
        const length = lengths[cell] + STEP_LENGTH[d]
        if (length >= lengths[next]) continue
        lengths[next] = length
        parents[next] = cell
        buckets[Math.floor(length) % 3].push(next)
        waiting++
        if (tape) tape.at(openLine).write(EVENT.open, next, cell, length)
      }
    }
    waiting -= bucket.length
    bucket.length = 0
  }
  return { found: false, parents, expanded }
}

/** The cells from the start to `goal` along the parents. */
export function pathTo(goal: Cell, parents: Int32Array): Int32Array {
  const path: Cell[] = []
  for (let cell = goal; cell >= 0; cell = parents[cell]) path.push(cell)
  return Int32Array.from(path.reverse())
}
