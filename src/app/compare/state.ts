import type { ComparedPlan, Subject } from './compared'

/** A plan with the subject that it answers, and its time once that was taken. */
export interface ComparisonEntry {
  readonly subject: Subject
  readonly plan: ComparedPlan
  /** Median; `null` until it was taken. */
  readonly milliseconds: number | null
}

/** All planners on the map on screen. */
export interface Comparison {
  readonly isOn: boolean
  /** The latest of each planner, in the planners' order. */
  readonly entries: readonly ComparisonEntry[]
  /** Planners whose paths are not drawn. */
  readonly hidden: readonly string[]
  /** Why there is none; empty unless it failed. */
  readonly fault: string
}

export const noComparison: Comparison = { isOn: false, entries: [], hidden: [], fault: '' }
