import { plannerById } from '../../algorithms/plan'
import { compareValues } from '../sorting'
import { lengthInWords, numberInWords, timeInWords } from '../words/numbers'
import type { ComparedPlan } from './compared'
import type { ComparisonEntry } from './state'

interface Column {
  readonly title: string
  readonly help: string
  /** What the table is sorted by; NaN where there is no value. */
  value(entry: ComparisonEntry): number | string
  show(entry: ComparisonEntry): string
}

const ofPath = ({ path }: ComparedPlan, value: number): number =>
  path.length > 0 ? value : Number.NaN

const orNone = (value: number | null): number => value ?? Number.NaN

const numeric = (
  title: string,
  help: string,
  value: (plan: ComparedPlan) => number,
  words: (value: number, plan: ComparedPlan) => string = numberInWords,
): Column => ({
  title,
  help,
  value: ({ plan }) => value(plan),
  show({ plan }) {
    const number = value(plan)
    return Number.isNaN(number) ? '–' : words(number, plan)
  },
})

const OUTCOMES = {
  reached: 'Reached',
  unreachable: 'Unreachable',
  'not-found': 'Not found',
  'local-minimum': 'Local minimum',
  'dead-end': 'Dead end',
  loop: 'Loop',
  refused: 'Not run',
} as const

/** Times below the resolution of one reading come from many. */
export const medianInWords = (milliseconds: number): string =>
  milliseconds < 0.9995 ? `${Math.round(milliseconds * 1000)} µs` : timeInWords(milliseconds)

/** The first one names the planner. */
export const COLUMNS: readonly Column[] = [
  {
    title: 'Planner',
    help: 'A tick shows its path on the map',
    value: ({ plan }) => plannerById(plan.plannerId).title,
    show: ({ plan }) => plannerById(plan.plannerId).title,
  },
  {
    title: 'Outcome',
    help: 'How it ended',
    value: ({ plan }) => OUTCOMES[plan.status],
    show: ({ plan }) => OUTCOMES[plan.status],
  },
  numeric('Cells', 'Of the path, or of the way so far; both ends included', (plan) =>
    ofPath(plan, plan.cells),
  ),
  numeric('Length', 'Euclidean, in cell sides', (plan) => ofPath(plan, plan.length), lengthInWords),
  numeric(
    'Ratio',
    'To the optimum, grid decomposition under the same rule: by steps, with * by Euclidean length',
    (plan) => orNone(plan.ratio),
    (ratio, { ratioBy }) => `${ratio.toFixed(2)}${ratioBy === 'length' ? '*' : ''}`,
  ),
  numeric('Turns', 'Changes of direction', (plan) => ofPath(plan, plan.turns)),
  numeric(
    'Effort',
    'Cells or vertices expanded; cells sensed by a rover',
    (plan) => (plan.effort > 0 ? plan.effort : Number.NaN),
    (effort, { plannerId }) => {
      const isOnline = plannerById(plannerId).family === 'online'
      return `${numberInWords(effort)} ${isOnline ? 'sensed' : 'exp.'}`
    },
  ),
  numeric('Walked', 'Steps of the path, or of the way so far', (plan) => ofPath(plan, plan.walked)),
  numeric(
    'At most',
    'Steps, by the bounds of Lumelsky and Stepanov; with † not promised',
    (plan) => orNone(plan.bound),
    (bound, { isBoundHeld }) =>
      isBoundHeld ? `≤ ${numberInWords(bound)}` : `${numberInWords(bound)}†`,
  ),
  {
    title: 'Time',
    help: 'To plan: the median of repeated runs',
    value: ({ milliseconds }) => orNone(milliseconds),
    show({ milliseconds, plan }) {
      if (milliseconds !== null) return medianInWords(milliseconds)
      return plan.status === 'refused' ? '–' : '…'
    },
  },
]

export interface SortOrder {
  readonly column: number
  readonly descending: boolean
}

/** Sorted by a column; entries without a value there come last in either direction. */
export function sortEntries(
  entries: readonly ComparisonEntry[],
  order: SortOrder | null,
): readonly ComparisonEntry[] {
  if (!order) return entries
  const { value } = COLUMNS[order.column]
  return entries.toSorted((a, b) => compareValues(value(a), value(b), order.descending))
}
