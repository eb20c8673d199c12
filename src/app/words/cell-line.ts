import { type Cell, cellName } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { type CellFacts, cellFacts } from '../../trace/cell-facts'
import type { Moment } from '../playback/moment'
import { countInWords, numberInWords } from './numbers'
import { asSentence } from './sentences'

/** "(7, 12), obstacle". */
export function cellInWords(problem: Problem, cell: Cell): string {
  const { grid, start, goal } = problem
  const names = [
    ...(cell === start ? ['start'] : []),
    ...(cell === goal ? ['goal'] : []),
    ...(grid.walls[cell] ? ['obstacle'] : []),
  ]
  return `${cellName(grid.width, cell)}, ${names.join(' and ') || 'free'}`
}

/** What the planner knows of a cell at this moment, as one sentence; empty if nothing. */
export function cellFactsInWords({ shown, frame }: Moment, problem: Problem, cell: Cell): string {
  const facts = cellFacts(shown.tape, frame, cell)
  const parts = [
    ...marks(facts),
    ...search(facts, shown.tape.width, problem.grid.walls[cell] === 1, frame.edgesCut),
    ...fields(facts),
    ...rover(facts),
  ]
  const text = parts.join('; ')
  return text && asSentence(text)
}

function marks({ hits, leaves, onMLine, onPath }: CellFacts): string[] {
  return [
    ...hits.map((number) => `hit point ${number}`),
    ...leaves.map((number) => `leave point ${number}`),
    ...(onMLine === null ? [] : [`cell ${onMLine} of the m-line`]),
    ...(onPath === null ? [] : [`cell ${onPath} of the path`]),
  ]
}

function search(facts: CellFacts, width: number, isObstacle: boolean, edgesCut: boolean): string[] {
  const { isVertex, edges, search, cost, parent } = facts
  const shown = `${edgesCut ? 'at least ' : ''}${countInWords(edges, 'edge')}`
  const degree = edges > 0 ? ` with ${shown}` : ''
  const way = parent === null || parent < 0 ? '' : ` by way of ${cellName(width, parent)}`
  return [
    ...(isVertex && !isObstacle ? [`vertex${degree}`] : []),
    ...(search === null ? [] : [`${search}, cost ${numberInWords(cost ?? 0)}${way}`]),
  ]
}

function fields({ attraction, repulsion, potential }: CellFacts): string[] {
  const parts = { attraction, repulsion, potential }
  return Object.entries(parts).flatMap(([name, value]) =>
    value === null ? [] : [`${name} ${numberInWords(value)}`],
  )
}

function rover({ sensed, isFelt, visits, node }: CellFacts): string[] {
  const times = visits.length > 3 ? ` (${visits.length} times)` : ''
  const latest = visits.slice(-3).map(numberInWords).join(', ')
  const steps = latest === '1' ? 'step' : 'steps'
  return [
    ...(visits.length === 0 ? [] : [`stood on after ${latest} ${steps}${times}`]),
    ...(isFelt ? ['at its side while it followed the boundary'] : []),
    ...(node === null ? [] : [`node, ${numberInWords(node)} over it to the goal`]),
    ...(sensed === null
      ? []
      : [
          sensed.walked === 0
            ? 'sensed from the start'
            : `sensed after ${countInWords(sensed.walked, 'step')} of the rover`,
        ]),
  ]
}
