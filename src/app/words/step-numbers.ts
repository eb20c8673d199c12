import { cellName } from '../../grid/grid'
import type { Moment } from '../playback/moment'
import { plannerOf } from '../state/setup'
import { countInWords, type NumberRow, numberInWords } from './numbers'
import { capitalised } from './sentences'

const YET_UNKNOWN = '–'

/**
 * The planner's numbers at this moment. Which rows there are depends on the whole plan, so that
 * they stay in their places while one steps through it.
 */
export function stepNumbers({ shown, frame }: Moment): NumberRow[] {
  const { tape, last, setup } = shown
  const { phases, variables, family } = plannerOf(setup)
  const isThinned = tape.thinning !== 'whole'
  const rows: NumberRow[] = []
  const row = (label: string, value: string) => rows.push({ label, value })

  if (phases.length > 0) row('Phase', phases[frame.phase] ?? YET_UNKNOWN)
  if (last.rover >= 0) {
    row('Position', frame.rover < 0 ? YET_UNKNOWN : cellName(tape.width, frame.rover))
    row('Walked', countInWords(Math.max(0, frame.trail.length - 1), 'step'))
  }
  if (family === 'online') {
    const side = isThinned ? 'followed' : `on the ${frame.turn === 0 ? 'left' : 'right'}`
    row('Boundary', frame.following ? side : 'not followed')
  }
  variables.forEach((name, i) => {
    // Not every way to plan decides by all of them, and a thinned tape leaves their values out.
    if (last.values[i] === undefined) return
    const value = frame.values[i]
    // A variable's own name, such as d_reach, stays as the pseudocode writes it.
    const label = name.includes('_') ? name : capitalised(name)
    row(label, value === undefined ? YET_UNKNOWN : valueInWords(value))
  })
  if (last.rows > 0) row('Rows of the graph', numberInWords(frame.rows))
  if (last.vertices.length > 0) {
    row('Vertices', numberInWords(frame.vertices.length))
    const edges = numberInWords(frame.edges.length / 2)
    row('Edges', frame.edgesCut ? `more than ${edges}` : edges)
  }
  if (last.open + last.closed > 0) {
    row('Cost', frame.open + frame.closed > 0 ? numberInWords(frame.cost) : YET_UNKNOWN)
    if (!isThinned) row('Open', numberInWords(frame.open))
    row('Closed', numberInWords(frame.closed))
  }
  return rows
}

/** Distances, potentials and places in a list are never negative: -1 stands for none. */
const valueInWords = (value: number): string => (value < 0 ? 'none' : numberInWords(value))
