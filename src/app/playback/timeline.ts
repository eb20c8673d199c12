import { landmarksOf, placeAfter, stepsOf } from '../../trace/landmarks'
import type { Tape } from '../../trace/tape'

/**
 * The moments of a tape between which the playback steps, and those of its landmarks; see `stepsOf`
 * and `landmarksOf`.
 */
export interface Timeline {
  readonly steps: Int32Array
  readonly landmarks: Int32Array
}

const timelines = new WeakMap<Tape, Timeline>()

/** Made when it is first asked for, and kept with the tape. */
export function timelineOf(tape: Tape): Timeline {
  const known = timelines.get(tape)
  if (known) return known
  const steps = stepsOf(tape)
  const timeline = { steps, landmarks: landmarksOf(tape, steps) }
  timelines.set(tape, timeline)
  return timeline
}

/** Keeps the timeline of a tape that the worker has made already. */
export function keepTimeline(tape: Tape, timeline: Timeline): void {
  timelines.set(tape, timeline)
}

/** The number of the step that `time` ends or is in the middle of; 0 before the first. */
export function stepAt({ steps }: Timeline, time: number): number {
  const ended = placeAfter(steps, time) - 1
  return steps[ended] === Math.min(time, steps[steps.length - 1]) ? ended : ended + 1
}

/** A place on a tape that can be found on another one too. */
export interface Place {
  /** How many landmarks have been passed, and how many steps after the last of them. */
  readonly landmarks: number
  readonly steps: number
}

export function placeOf(timeline: Timeline, time: number): Place {
  const landmarks = placeAfter(timeline.landmarks, time)
  const steps = stepAt(timeline, time) - stepOfLandmark(timeline, landmarks)
  return { landmarks, steps }
}

/**
 * The moment of that place: after as many landmarks, and as many steps after them as there are
 * before the next one; the end if there are not so many landmarks.
 */
export function timeOfPlace(timeline: Timeline, { landmarks, steps }: Place): number {
  const { length } = timeline.landmarks
  if (landmarks > length) return timeline.steps[timeline.steps.length - 1]
  const next = landmarks < length ? stepOfLandmark(timeline, landmarks + 1) : timeline.steps.length
  return timeline.steps[Math.min(stepOfLandmark(timeline, landmarks) + steps, next - 1)]
}

/** The step that leads to the landmark of this number, counted from 1; 0 for none. */
function stepOfLandmark(timeline: Timeline, number: number): number {
  return number === 0 ? 0 : placeAfter(timeline.steps, timeline.landmarks[number - 1]) - 1
}
