import type { Cell } from '../grid/grid'
import { int32View } from '../grid/int32-view'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'
import { EVENT } from '../trace/events'
import type { Tape } from '../trace/tape'
import { costParam } from './costs'
import { aStar } from './grid-search/a-star'
import { dijkstra } from './grid-search/dijkstra'
import { jumpPointSearch } from './grid-search/jump-point'
import type { CellSearch } from './grid-search/search'
import type { Param } from './params'
import { offlinePlanner } from './planner'
import { pseudocode } from './pseudocode'
import { searchParam } from './search-param'

const { text, line } = pseudocode({
  graph: 'graph ← the free cells; edges join cells one legal step apart',
  start: 'open the start, with cost 0',
  close:
    'close the open cell of least cost (dijkstra: by its whole part, as no step costs less than 1; a-star, jump-point: cost so far and what is left at least): its way is final; open each neighbour that gets a shorter way over it, except those that its parent reaches as cheaply',
  jump: 'jump-point: instead of a neighbour open the next cell that way where a path has a choice',
  found: 'if it is the goal: follow the parents back to the start',
  none: 'if no cell is open: no path exists',
})

const SEARCHES = {
  dijkstra,
  'a-star': aStar,
  'jump-point': jumpPointSearch,
} satisfies Record<string, CellSearch>

const cellSearchParam = {
  ...searchParam,
  choices: [...searchParam.choices, 'jump-point'],
  help: 'dijkstra: the report’s, by the cost so far; a-star: by that plus the least cost of what is left; jump-point: a-star over the cells where a path has a choice. The same cost, with fewer expanded.',
} as const satisfies Param

export const decomposition = offlinePlanner({
  id: 'decomposition',
  title: 'Grid decomposition',
  summary:
    "The map is a graph of free cells joined by legal steps; Dijkstra's algorithm, or A*, finds its shortest path.",
  promise: 'Complete and optimal: the least cost there is, or a proof that no path exists.',
  complete: () => true,
  optimal: () => true,
  params: [cellSearchParam, costParam],
  phases: ['Decompose the map into cells', 'Search', 'Path'],
  variables: ['least cost of a path over this cell'],
  pseudocode: text,
  source: 'Report, IV.A; E. W. Dijkstra, "A note on two problems in connexion with graphs", 1959',

  plan(problem, { params, tape, progress }) {
    const legal = allLegalSteps(problem.grid, problem.diagonal)
    if (tape) recordGraph(problem, legal, tape)
    tape?.at(line.start).write(EVENT.phase, -1, 1)
    const task = { problem, legal, cost: params.cost, tape, lines: line, progress }
    const { path, expanded } = SEARCHES[params.search](task)
    if (path.length === 0) {
      tape?.at(line.none)
      const reason = 'every cell that can be reached from the start was tried'
      return { status: 'unreachable', reason, path, expanded }
    }
    tape?.at(line.found).write(EVENT.phase, -1, 2)
    if (tape) for (const cell of path) tape.write(EVENT.path, cell)
    return { status: 'reached', reason: 'the path of least cost', path, expanded }
  },
})

/** The cells of the map become the vertices of a graph, row by row. */
function recordGraph(problem: Problem, legal: Uint8Array, tape: Tape): void {
  tape.at(line.graph).write(EVENT.phase, -1, 0)
  const { width } = problem.grid
  const free = freeInRows(problem, legal)
  for (let y = 0; y < free.length; y++) tape.write(EVENT.row, y * width, free[y])
}

/** What was counted, by the legal steps of the map. */
const counted = new WeakMap<Uint8Array, Int32Array>()

/** How many cells of each row are free. */
function freeInRows({ grid: { width, height, walls } }: Problem, legal: Uint8Array): Int32Array {
  const known = counted.get(legal)
  if (known) return known
  const words = int32View(walls)
  const free = new Int32Array(height).map((_, y) => {
    return width - countObstacles(walls, words, y * width, (y + 1) * width)
  })
  counted.set(legal, free)
  return free
}

/** Obstacles from one cell up to another. @param words of `walls`, as far as there are any */
function countObstacles(walls: Uint8Array, words: Int32Array, from: Cell, to: Cell): number {
  const lastWord = Math.min(to >> 2, words.length)
  let count = 0
  let cell = from
  for (; cell < to && (cell & 3) !== 0; cell++) count += walls[cell]
  while (cell >> 2 < lastWord) {
    // So many words add up without a carry from byte to byte, and so do their four bytes then.
    const end = Math.min(lastWord, (cell >> 2) + 63)
    let sums = 0
    for (let i = cell >> 2; i < end; i++) sums += words[i]
    count += Math.imul(sums, 0x01010101) >>> 24
    cell = end << 2
  }
  for (; cell < to; cell++) count += walls[cell]
  return count
}
