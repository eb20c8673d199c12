import type { Scene } from '../render/scene'
import { darkTheme, lightTheme } from '../render/theme'
import type { Frame } from '../trace/frame'
import { plannerOf, type Setup, valuesOf } from './setup'
import { type State, visiblePlan } from './state'

/** What is to be drawn. @param frame the picture of the plan at this moment; `null` for its end */
export function sceneOf(state: State, isDark: boolean, frame: Frame | null): Scene {
  const { setup, preferences, cursor, cursorShown } = state
  const shown = visiblePlan(state)
  return {
    problem: setup.problem,
    theme: isDark ? darkTheme : lightTheme,
    plan: shown && { tape: shown.tape, frame: frame ?? shown.last },
    sensorRange: sensorRangeOf(shown?.setup ?? setup),
    sight: 'both',
    // Where there is none, nothing need look for it in a long tape.
    showPotential: preferences.showPotential && shown !== null && shown.last.field !== null,
    cursor: cursorShown ? cursor : -1,
    hovered: -1,
  }
}

function sensorRangeOf(setup: Setup): number {
  const planner = plannerOf(setup)
  return planner.family === 'online' ? planner.sensor(valuesOf(setup)).range : 0
}
