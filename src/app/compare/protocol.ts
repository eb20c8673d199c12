import type { ComparedPlan, Subject } from './compared'

/** What the page asks its comparing worker. A new question takes the place of the one before. */
export interface CompareQuestion {
  readonly id: number
  readonly subject: Subject
}

/**
 * What the worker says to it, with the number of the question: a plan for each planner, then that
 * these are all, then how long each took, then that it has finished.
 */
export type CompareAnswer =
  | { readonly kind: 'planned'; readonly id: number; readonly plan: ComparedPlan }
  | { readonly kind: 'compared'; readonly id: number }
  | {
      readonly kind: 'timed'
      readonly id: number
      readonly plannerId: string
      readonly milliseconds: number
    }
  | { readonly kind: 'finished'; readonly id: number }
  | { readonly kind: 'failed'; readonly id: number; readonly message: string }
