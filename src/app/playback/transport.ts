import { momentAfter, momentBefore, placeAfter } from '../../trace/landmarks'
import { type Said, type Shown, type State, THE_END, visiblePlan } from '../state/state'
import { prefer, say } from '../state/transitions'
import { noStepsInWords } from '../words/steps-in-words'
import { isFast, type Speed, speedInWords, tempoOf } from './speeds'
import { stepAt, type Timeline, timelineOf } from './timeline'

// Moves of the cursor on the tape of the plan; all are transitions.

/** A new object each time, because the same one would not be said again. */
const sayStep = (): Said => ({ text: '', followedBy: 'step' })

/** How many events of the plan on screen have happened. */
const timeIn = (state: State, { tape }: Shown): number => Math.min(state.time, tape.length)

/** The cursor put to a moment by the user: it stays there. */
function put(state: State, { tape }: Shown, time: number, said: Said): State {
  const at = time < tape.length ? time : THE_END
  return { ...state, time: at, playing: null, kept: null, said }
}

function move(state: State, to: (timeline: Timeline, time: number) => number): State {
  const shown = visiblePlan(state)
  if (!shown) return say(state, noStepsInWords(state))
  const time = to(timelineOf(shown.tape), timeIn(state, shown))
  return put(state, shown, time, sayStep())
}

export const stepForward = (state: State): State =>
  move(state, ({ steps }, time) => momentAfter(steps, time))

export const stepBack = (state: State): State =>
  move(state, ({ steps }, time) => momentBefore(steps, time))

export const toNextLandmark = (state: State): State =>
  move(state, ({ landmarks }, time) => momentAfter(landmarks, time))

export const toLandmarkBefore = (state: State): State =>
  move(state, ({ landmarks }, time) => momentBefore(landmarks, time))

export const toFirst = (state: State): State => move(state, () => 0)

export const toLast = (state: State): State => move(state, () => THE_END)

/** To the step of this number. It is said only at landmarks: the scrubber says each step itself. */
export function toStep(state: State, step: number): State {
  const shown = visiblePlan(state)
  if (!shown) return state
  const { steps, landmarks } = timelineOf(shown.tape)
  const time = steps[Math.max(0, Math.min(step, steps.length - 1))]
  const isLandmark = landmarks[placeAfter(landmarks, time) - 1] === time
  return put(state, shown, time, isLandmark ? sayStep() : state.said)
}

/** To the step of this number, which is said. */
export const jumpToStep = (state: State, step: number): State => ({
  ...toStep(state, step),
  said: sayStep(),
})

/** Plays on, from the beginning if the end is reached; or stops where it is. */
export function togglePlay(state: State): State {
  if (state.playing) return { ...state, playing: null, said: sayStep() }
  const shown = visiblePlan(state)
  if (!shown) return say(state, 'There is no plan to play.')
  const time = state.time < shown.tape.length ? state.time : 0
  const playing = tempoOf(state.preferences.speed)
  return { ...say(state, 'Playing.'), time, playing, kept: null }
}

export function chooseSpeed(state: State, speed: Speed): State {
  const chosen = say(prefer(state, { speed }), `Speed: ${speedInWords(speed)}.`)
  return chosen.playing ? { ...chosen, playing: tempoOf(speed) } : chosen
}

/** It has been played to this moment. Slow playing says each landmark, fast playing only the end. */
export function played(state: State, time: number): State {
  const shown = visiblePlan(state)
  if (!shown || !state.playing) return state
  const { tape } = shown
  if (time >= tape.length) {
    const isAsked = state.playing.kind === 'steps' || state.playing.asked
    return put(state, shown, THE_END, isAsked ? sayStep() : state.said)
  }
  if (time === state.time) return state
  const moved = { ...state, time, kept: null }
  if (isFast(state.playing)) return moved
  const { landmarks } = timelineOf(tape)
  const hasPassed = placeAfter(landmarks, time) > placeAfter(landmarks, state.time)
  return hasPassed ? { ...moved, said: sayStep() } : moved
}

/** The number of the step on screen, and how many there are. */
export function stepNumber(state: State, shown: Shown): { step: number; steps: number } {
  const timeline = timelineOf(shown.tape)
  return { step: stepAt(timeline, timeIn(state, shown)), steps: timeline.steps.length - 1 }
}
