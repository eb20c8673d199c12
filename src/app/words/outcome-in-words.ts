import type { Outcome } from '../../algorithms/plan'
import { cellName } from '../../grid/grid'
import type { Status } from '../../trace/events'
import { cellsInWords, lengthInWords, type NumberRow, numberInWords, timeInWords } from './numbers'
import { asSentence } from './sentences'

/** How good the news is: it gets its own colour and icon. */
export type Tone = 'good' | 'proof' | 'bad'

export const toneOf = (status: Status): Tone =>
  status === 'reached' ? 'good' : status === 'unreachable' ? 'proof' : 'bad'

/**
 * What came out, in one line.
 * @param width of the map, to name the cell at which a path ends
 */
export function outcomeInWords({ status, reason, path }: Outcome, width: number): string {
  const last = path.at(-1)
  const where = last === undefined ? '' : ` at ${cellName(width, last)}`
  switch (status) {
    case 'reached':
      return `Reached in ${cellsInWords(path.length)}`
    case 'unreachable':
      return `Proven unreachable: ${reason}`
    case 'not-found':
      return `No path found: ${reason}`
    case 'local-minimum':
      return `Stuck in a local minimum${where}`
    case 'dead-end':
      return `Dead end${where}`
    case 'loop':
      return `Loop: ${reason}`
  }
}

/** The rest of the story, as a sentence; empty where the words have told it already. */
export function reasonInWords({ status, reason }: Outcome): string {
  if (status === 'unreachable' || status === 'not-found' || status === 'loop') return ''
  return asSentence(reason)
}

/** The numbers that belong to an outcome. */
export function outcomeNumbers(
  { status, path, measure, expanded, sensed }: Outcome,
  milliseconds: number,
  family: 'offline' | 'online',
): NumberRow[] {
  const walked = status === 'reached' ? 'Path' : 'Walked so far'
  const rows = [{ label: 'Time to plan', value: timeInWords(milliseconds) }]
  if (path.length > 0) {
    rows.push(
      { label: walked, value: cellsInWords(path.length) },
      { label: 'Euclidean length', value: lengthInWords(measure.length) },
      { label: 'Turns', value: numberInWords(measure.turns) },
    )
  }
  if (family === 'online') rows.push({ label: 'Sensed', value: cellsInWords(sensed) })
  else if (expanded > 0) rows.push({ label: 'Expanded', value: numberInWords(expanded) })
  return rows
}
