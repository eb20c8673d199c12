import { EVENT } from './events'
import { kindTable } from './kind-table'
import type { Tape } from './tape'

/** Events that tell more of the event before them, so that no step ends between the two. */
export const isAttached = kindTable([
  EVENT.turn,
  EVENT.feel,
  EVENT.sense,
  EVENT.value,
  EVENT.estimate,
  EVENT.node,
])

/** Events of which all that follow one another make one step: cell by cell would be tedious. */
const isRun = kindTable([EVENT.mLine, EVENT.path])

/** Fields are written cell by cell and stepped row by row. */
const isField = kindTable([EVENT.attraction, EVENT.repulsion, EVENT.potential])

const isLandmark = kindTable([
  EVENT.phase,
  EVENT.hit,
  EVENT.around,
  EVENT.leave,
  EVENT.loop,
  EVENT.end,
])

/** Whether the event, which is not the first, begins a step of its own. */
function beginsStep(tape: Tape, i: number): boolean {
  const kind = tape.kind(i)
  if (isAttached[kind]) return false
  if (isRun[kind]) return tape.kind(i - 1) !== kind
  return !isField[kind] || tape.cell(i) % tape.width === 0
}

/**
 * The moments between which the player steps, each as a number of events from the beginning: 0,
 * then the end of each step, the last of which is the end of the tape.
 */
export function stepsOf(tape: Tape): Int32Array {
  const moments = new Int32Array(tape.length + 1)
  let count = 1
  for (let i = 1; i < tape.length; i++) if (beginsStep(tape, i)) moments[count++] = i
  if (tape.length > 0) moments[count++] = tape.length
  return moments.slice(0, count)
}

/** Those moments of `stepsOf` at which a step with a landmark ends: a hit or leave point, a new phase, the end. */
export function landmarksOf(tape: Tape, steps: Int32Array): Int32Array {
  const moments: number[] = []
  for (let i = 1; i < steps.length; i++) {
    if (isLandmark[tape.kind(steps[i - 1])]) moments.push(steps[i])
  }
  return Int32Array.from(moments)
}

/** The first moment after `time`; the last one if there is none. Moments rise. */
export function momentAfter(moments: Int32Array, time: number): number {
  return moments[Math.min(placeAfter(moments, time), moments.length - 1)] ?? 0
}

/** The last moment before `time`; 0 if there is none. */
export function momentBefore(moments: Int32Array, time: number): number {
  return moments[placeAfter(moments, time - 1) - 1] ?? 0
}

/** How many of the moments are not after `time`. */
export function placeAfter(moments: Int32Array, time: number): number {
  let low = 0
  let high = moments.length
  while (low < high) {
    const middle = (low + high) >> 1
    if (moments[middle] <= time) low = middle + 1
    else high = middle
  }
  return low
}
