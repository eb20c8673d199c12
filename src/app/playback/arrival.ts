import { type Shown, type State, THE_END } from '../state/state'
import type { Tempo } from './speeds'
import { placeOf, timelineOf, timeOfPlace } from './timeline'

/** If the whole plan is being played, it comes to its end at once. */
export function endWelcome(state: State): State {
  const { playing } = state
  return playing?.kind === 'whole' ? { ...state, time: THE_END, playing: null } : state
}

type Cursor = Pick<State, 'time' | 'playing' | 'kept'>

/**
 * Where the cursor is on a new plan. If it was at the end, the new plan is played to its end. In the
 * middle it stays after the same landmark and as many steps. What counts then is the place where the
 * user put it, not the places where it came to lie on plans in between.
 * @param welcome how a new plan is played; `null` if its end is to be shown at once
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
