import { landmarksOf, placeAfter, stepsOf } from '../trace/landmarks'
import type { Tape } from '../trace/tape'

/** The moments of a tape between which one steps, and those of its landmarks. */
export interface Score {
  readonly steps: Int32Array
  readonly landmarks: Int32Array
}

const scores = new WeakMap<Tape, Score>()

/** Reckoned when it is first asked for, once for each tape. */
export function scoreOf(tape: Tape): Score {
  const known = scores.get(tape)
  if (known) return known
  const steps = stepsOf(tape)
  const score = { steps, landmarks: landmarksOf(tape, steps) }
  scores.set(tape, score)
  return score
}

/** Takes over the score of a tape, as the worker has found it. */
export function keepScore(tape: Tape, score: Score): void {
  scores.set(tape, score)
}

/** The number of the step that `time` ends or is in the middle of; 0 before the first. */
export function stepAt({ steps }: Score, time: number): number {
  const ended = placeAfter(steps, time) - 1
  return steps[ended] === Math.min(time, steps[steps.length - 1]) ? ended : ended + 1
}

/** A place on a tape that can be found on another one too. */
export interface Place {
  /** How many landmarks have been passed, and how many steps after the last of them. */
  readonly landmarks: number
  readonly steps: number
}

export function placeOf(score: Score, time: number): Place {
  const landmarks = placeAfter(score.landmarks, time)
  const steps = stepAt(score, time) - stepOfLandmark(score, landmarks)
  return { landmarks, steps }
}

/**
 * The moment of that place: after as many landmarks, and as many steps after them as there are
 * before the next one; the end if there are not so many landmarks.
 */
export function timeOfPlace(score: Score, { landmarks, steps }: Place): number {
  const { length } = score.landmarks
  if (landmarks > length) return score.steps[score.steps.length - 1]
  const next = landmarks < length ? stepOfLandmark(score, landmarks + 1) : score.steps.length
  return score.steps[Math.min(stepOfLandmark(score, landmarks) + steps, next - 1)]
}

/** The step that leads to the landmark of this number, counted from 1; 0 for none. */
function stepOfLandmark(score: Score, number: number): number {
  return number === 0 ? 0 : placeAfter(score.steps, score.landmarks[number - 1]) - 1
}
