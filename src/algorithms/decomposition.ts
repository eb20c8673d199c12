import { EVENT } from '../trace/events'
import { costParam } from './costs'
import { pathTo, searchByCells, searchByLength } from './grid-search'
import { offlinePlanner } from './planner'
import { pseudocode } from './pseudocode'

const { text, line } = pseudocode({
  graph: 'graph ← the free cells; edges join cells one legal step apart',
  open: 'put the start, then each cell that gets a shorter way, among the open cells',
  close: 'take the open cell with the least cost and close it: its way is final',
  found: 'if it is the goal: follow the parents back to the start',
  none: 'if no cell is open: no path exists',
})

export const decomposition = offlinePlanner({
  id: 'decomposition',
  title: 'Grid decomposition',
  summary:
    "The map is a graph of free cells joined by legal steps; Dijkstra's algorithm finds its shortest path.",
  promise: 'Complete and optimal: the least cost there is, or a proof that no path exists.',
  complete: () => true,
  optimal: () => true,
  params: [costParam],
  pseudocode: text,
  source: 'Report, IV.A; E. W. Dijkstra, "A note on two problems in connexion with graphs", 1959',

  plan(problem, { params, tape, progress }) {
    const notes = { tape, openLine: line.open, closeLine: line.close, progress }
    const search = params.cost === 'cells' ? searchByCells : searchByLength
    const { found, parents, expanded } = search(problem, notes)
    if (!found) {
      tape?.at(line.none)
      const reason = 'every cell that can be reached from the start was tried'
      return { status: 'unreachable', reason, path: new Int32Array(0), expanded }
    }
    const path = pathTo(problem.goal, parents)
    tape?.at(line.found)
    for (const cell of path) tape?.write(EVENT.path, cell)
    return { status: 'reached', reason: 'the path of least cost', path, expanded }
  },
})
