import type { Scene } from '../render/scene'
import type { Theme } from '../render/theme'
import { comparedPaths } from './compare/paths'
import type { Moment } from './playback/moment'
import { plannerOf, type Setup, valuesOf } from './state/setup'
import type { State } from './state/state'

/** What is to be drawn. */
export function sceneOf(state: State, moment: Moment | null, theme: Theme): Scene {
  const { setup, preferences, cursor, cursorShown, hovered } = state
  const shown = moment?.shown
  return {
    problem: setup.problem,
    theme,
    plan: moment && { tape: moment.shown.tape, frame: moment.frame },
    sensorRange: sensorRangeOf(shown?.setup ?? setup),
    sight: preferences.sight,
    // Only if there are any: a long tape takes a while to be searched for them.
    showPotential: preferences.showPotential && shown !== undefined && shown.last.field !== null,
    comparison: comparedPaths(state),
    cursor: cursorShown ? cursor : -1,
    hovered,
  }
}

function sensorRangeOf(setup: Setup): number {
  const planner = plannerOf(setup)
  return planner.family === 'online' ? planner.sensor(valuesOf(setup)).range : 0
}
