import { plannerById } from '../algorithms/plan'
import { withScenario } from './dialogs/scenarios'
import { scenarios } from './scenarios'
import type { Setup } from './setup'
import type { Loaded } from './storage'

const FIRST_SCENARIO = 'fig14-tangent-bug'

/** What newcomers see: a map that is solved already. */
export function firstSetup(): Setup {
  const scenario = scenarios.find(({ id }) => id === FIRST_SCENARIO) ?? scenarios[0]
  const { problem, planner } = scenario
  const bare = { problem, plannerId: plannerById(planner).id, params: {}, seed: 1 }
  return withScenario(bare, scenario)
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
