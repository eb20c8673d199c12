import { planners } from '../../algorithms/planners'
import type { State } from '../state/state'
import { cellsInWords } from '../words/numbers'
import { type ComparedPlan, isSameSubject, type Subject } from './compared'
import { type Comparison, type ComparisonEntry, noComparison } from './state'

const withComparison = (state: State, some: Partial<Comparison>): State => ({
  ...state,
  comparison: { ...state.comparison, ...some },
})

const ORDER = planners.map(({ id }) => id)

/** Begins or ends the comparison; which paths are hidden is remembered. */
export function toggleComparison(state: State): State {
  const { isOn, hidden } = state.comparison
  if (isOn) {
    const said = { text: 'The comparison has ended.', followedBy: 'nothing' } as const
    return { ...state, comparison: { ...noComparison, hidden }, said }
  }
  return withComparison(state, { isOn: true })
}

export function planCompared(state: State, subject: Subject, plan: ComparedPlan): State {
  if (!state.comparison.isOn) return state
  const others = state.comparison.entries.filter((entry) => entry.plan.plannerId !== plan.plannerId)
  const place = ({ plan: { plannerId } }: ComparisonEntry) => ORDER.indexOf(plannerId)
  const entries = [...others, { subject, plan, milliseconds: null }]
  entries.sort((a, b) => place(a) - place(b))
  return withComparison(state, { entries, fault: '' })
}

export function planTimed(
  state: State,
  subject: Subject,
  plannerId: string,
  milliseconds: number,
): State {
  const entries = state.comparison.entries.map((entry) =>
    entry.plan.plannerId === plannerId && isSameSubject(entry.subject, subject)
      ? { ...entry, milliseconds }
      : entry,
  )
  return withComparison(state, { entries })
}

/** Says that the comparison is ready, if it is that of the map on screen. */
export function comparisonReady(state: State, subject: Subject): State {
  if (!state.comparison.isOn || !isSameSubject(subject, state.setup)) return state
  return { ...state, said: { text: comparisonInWords(state.comparison), followedBy: 'nothing' } }
}

export function comparisonFailed(state: State, subject: Subject, message: string): State {
  if (!state.comparison.isOn || !isSameSubject(subject, state.setup)) return state
  return withComparison(state, { entries: [], fault: `Nothing was compared: ${message}.` })
}

/** Shows or hides the path of a planner. */
export function togglePath(state: State, plannerId: string): State {
  const { hidden } = state.comparison
  const others = hidden.filter((id) => id !== plannerId)
  const isHidden = others.length < hidden.length
  return withComparison(state, { hidden: isHidden ? others : [...hidden, plannerId] })
}

export function comparisonInWords({ entries }: Comparison): string {
  const reached = entries.map(({ plan }) => plan).filter(({ status }) => status === 'reached')
  if (reached.length === 0) return `Compared: none of ${entries.length} planners reaches the goal.`
  const [shortest] = reached.toSorted((a, b) => a.cells - b.cells)
  const title = planners.find(({ id }) => id === shortest.plannerId)?.title
  const count = `${reached.length} of ${entries.length} planners reach the goal`
  return `Compared: ${count}; the shortest path has ${cellsInWords(shortest.cells)} (${title}).`
}
