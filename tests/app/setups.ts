import { plan } from '../../src/algorithms/plan'
import { defaultPreferences } from '../../src/app/state/preferences'
import type { Setup } from '../../src/app/state/setup'
import { settingsOf } from '../../src/app/state/setup'
import { initialState, type Shown, type State } from '../../src/app/state/state'
import { planArrived } from '../../src/app/state/transitions'
import { problemFromText } from '../../src/grid/text-map'
import { foldWhole } from '../../src/trace/checkpoints'
import { Tape } from '../../src/trace/tape'

/** Bug2 goes round the hook in several steps and landmarks. */
export const HOOK = ['S......', '.####..', '....#..', '.####..', '......G'].join('\n')
/** The same with one more obstacle, far from where the first landmarks are. */
export const LONGER_HOOK = ['S......', '.####..', '....#..', '.#####.', '......G'].join('\n')

export function setupFrom(text: string, plannerId = 'decomposition'): Setup {
  return { problem: problemFromText(text), plannerId, params: {}, seed: 1 }
}

/** A state whose cells are 40 pixels wide, the first at the top left of the screen. */
export function stateFrom(text: string): State {
  const state = initialState(setupFrom(text), defaultPreferences)
  return { ...state, view: { scale: 40, left: 0, top: 0 }, screen: { width: 800, height: 600 } }
}

/** What the worker would answer. */
export function planned(setup: Setup): Shown {
  const tape = new Tape()
  const { problem, plannerId, seed } = setup
  const outcome = plan(problem, plannerId, { params: settingsOf(setup), seed, tape })
  const { last, checkpoints } = foldWhole(tape)
  return { setup, outcome, tape, last, checkpoints, milliseconds: 1, instant: false }
}

/** A plan on screen. */
export function shownState(text: string, plannerId = 'bug2'): State & { readonly shown: Shown } {
  const setup = setupFrom(text, plannerId)
  const shown = planned(setup)
  return { ...planArrived({ ...stateFrom(text), setup, committed: setup }, shown), shown }
}

/** The cells that are obstacles. */
export function obstaclesOf({ problem }: Setup): number[] {
  return [...problem.grid.walls.keys()].filter((cell) => problem.grid.walls[cell] === 1)
}
