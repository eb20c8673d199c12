import { slantingWall, withScenario } from './scenarios/scenario'
import type { Setup } from './state/setup'
import type { Loaded } from './storage/storage'

/** What newcomers see: a map that is solved already. */
export function firstSetup(): Setup {
  const { problem, planner } = slantingWall
  return withScenario({ problem, plannerId: planner, params: {}, seed: 1 }, slantingWall)
}

export interface Beginning {
  readonly setup: Setup
  readonly isFirstVisit: boolean
  /** What has to be said about it; empty if nothing. */
  readonly message: string
}

export function beginWith(loaded: Loaded): Beginning {
  switch (loaded.kind) {
    case 'setup':
      return { setup: loaded.setup, isFirstVisit: false, message: '' }
    case 'nothing':
      return { setup: firstSetup(), isFirstVisit: true, message: '' }
    case 'broken':
      return {
        setup: firstSetup(),
        isFirstVisit: true,
        message: 'What was drawn before could not be read, so the page begins anew.',
      }
  }
}
