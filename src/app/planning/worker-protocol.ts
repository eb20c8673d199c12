import type { ParamSettings } from '../../algorithms/params'
import type { Outcome } from '../../algorithms/plan'
import type { Problem } from '../../grid/problem'
import type { Frame } from '../../trace/frame'
import type { TapeData } from '../../trace/tape'
import type { Timeline } from '../playback/timeline'
import { type Setup, settingsOf } from '../state/setup'

/** What the page asks its planning worker. */
export interface WorkerQuestion {
  readonly id: number
  readonly problem: Problem
  readonly plannerId: string
  readonly params: ParamSettings
  readonly seed: number
}

/** What the worker says to it, with the number of the question. */
export type WorkerAnswer =
  | { readonly kind: 'progress'; readonly id: number; readonly done: number }
  | {
      readonly kind: 'planned'
      readonly id: number
      readonly outcome: Outcome
      readonly tape: TapeData
      readonly last: Frame
      readonly checkpoints: readonly Frame[]
      readonly timeline: Timeline
      readonly milliseconds: number
    }
  | { readonly kind: 'refused'; readonly id: number; readonly message: string }

export function questionOf(id: number, setup: Setup): WorkerQuestion {
  const { problem, plannerId, seed } = setup
  return { id, problem, plannerId, params: settingsOf(setup), seed }
}
