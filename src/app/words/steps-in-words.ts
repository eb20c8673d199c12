import { explain } from '../../trace/explain'
import { placeAfter } from '../../trace/landmarks'
import { isAtEnd, type Moment } from '../playback/moment'
import { stepAt, timelineOf } from '../playback/timeline'
import { plannerOf } from '../state/setup'
import type { State } from '../state/state'
import { asSentence } from './sentences'

export const noStepsInWords = ({ run }: State): string =>
  `There is no plan to step through${run.kind === 'running' ? ' yet' : ''}.`

/** Why the planner does what it does at this moment; at the end with the reason of the outcome. */
export function stepInWords(moment: Moment): string {
  const { shown, frame } = moment
  const { tape, outcome } = shown
  if (frame.time === 0) return 'Before the first step.'
  if (isAtEnd(moment)) {
    return `${sentence(moment, tape.length - 1)} ${asSentence(outcome.reason)}`
  }
  const timeline = timelineOf(tape)
  return sentence(moment, timeline.steps[stepAt(timeline, frame.time) - 1])
}

/** The latest landmark in words: what can be followed when steps fly by. */
export function landmarkInWords(moment: Moment): string {
  const { shown, frame } = moment
  if (isAtEnd(moment)) return stepInWords(moment)
  const { steps, landmarks } = timelineOf(shown.tape)
  const passed = placeAfter(landmarks, frame.time)
  if (passed === 0) return `${plannerOf(shown.setup).title} begins.`
  return sentence(moment, steps[placeAfter(steps, landmarks[passed - 1]) - 2])
}

/** @param first the event with which the step begins */
function sentence({ shown, frame }: Moment, first: number): string {
  return explain(shown.tape, first, frame, plannerOf(shown.setup).phases)
}
