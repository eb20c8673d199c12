import type { Tempo } from './speeds'
import { type Shown, type State, THE_END } from './state'
import { placeOf, timelineOf, timeOfPlace } from './timeline'

/** What is played because a plan is new comes to its end at once. */
export function endWelcome(state: State): State {
  const { playing } = state
  return playing?.kind === 'whole' ? { ...state, time: THE_END, playing: null } : state
}

type Cursor = Pick<State, 'time' | 'playing' | 'kept'>

/**
 * Where the cursor is on a plan that takes the place of the one before. In the middle it stays
 * after the same landmark, by the place where it was put: not by that where it came to lie on plans
 * in between. At the end the new plan is played.
 * @param welcome how; `null` if it is to be shown at once
 */
export function cursorOn(state: State, shown: Shown, welcome: Tempo | null): Cursor {
  const before = state.shown
  const isSamePlanner = before?.setup.plannerId === shown.setup.plannerId
  if (!before || !isSamePlanner || (state.time === THE_END && !state.kept)) {
    return { time: welcome ? 0 : THE_END, playing: welcome, kept: null }
  }
  const kept =
    state.kept ?? placeOf(timelineOf(before.tape), Math.min(state.time, before.tape.length))
  const time = timeOfPlace(timelineOf(shown.tape), kept)
  return { time: time < shown.tape.length ? time : THE_END, playing: state.playing, kept }
}
