import { test } from 'vitest'
import { EVENT, type Frame, frameAt, Player, planners, Tape } from '../../src/index'
import { explain } from '../../src/trace/explain'
import { landmarksOf, momentAfter, momentBefore, stepsOf } from '../../src/trace/landmarks'
import { LONG, must, onEveryMap } from '../reference/cases'
import { Dice } from '../reference/random'
import { run } from '../reference/run'
import { anySettings } from '../reference/settings'

/** A frame as text, NaN and all, so that two can be compared whole. */
function picture(frame: Frame): string {
  return JSON.stringify(frame, (_, value) =>
    ArrayBuffer.isView(value) ? Array.from(value as Float64Array, String) : value,
  )
}

test('stepping, stepping back and jumping lead to the same frames', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    if (index % 8 !== 0 || world.width * world.height > 200) return
    const dice = new Dice(11, index)
    for (const planner of planners) {
      const tape = new Tape()
      const { name } = run(world, planner.id, anySettings(planner.params, dice), tape)
      const steps = stepsOf(tape)
      const stride = Math.max(1, Math.floor(steps.length / 12))
      const player = new Player(tape)
      const forwards = new Map<number, string>()
      for (let time = 0, i = 0; ; i++, time = momentAfter(steps, time)) {
        const frame = player.moveTo(time)
        if (i % stride === 0 || time === tape.length) forwards.set(time, picture(frame))
        if (time === tape.length) break
      }
      must(forwards.size > 1, () => `${name}: nothing to step through`)
      for (let time = tape.length; time > 0; time = momentBefore(steps, time)) {
        if (!forwards.has(time)) continue
        const back = picture(player.moveTo(time))
        must(back === forwards.get(time), () => `${name}: another frame at ${time} on the way back`)
        const jump = picture(frameAt(tape, time))
        must(jump === forwards.get(time), () => `${name}: another frame at ${time} by a jump`)
      }
    }
  })
})

test('every step has its reason, and the last one is a landmark', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    if (index % 8 !== 1 || world.width * world.height > 200) return
    const dice = new Dice(12, index)
    for (const planner of planners) {
      const tape = new Tape()
      const { name } = run(world, planner.id, anySettings(planner.params, dice), tape)
      const steps = stepsOf(tape)
      const player = new Player(tape)
      for (let i = 1; i < steps.length; i++) {
        const sentence = explain(tape, steps[i - 1], player.moveTo(steps[i]), planner.phases)
        must(
          /^[A-Z(\d].*\.$/.test(sentence) && !/undefined|NaN/.test(sentence),
          () => `${name}: step ${i} is explained as "${sentence}"`,
        )
        // What is marked in the pseudocode is what the sentence tells.
        must(
          tape.line(steps[i - 1]) === tape.line(steps[i] - 1),
          () => `${name}: step ${i} begins and ends in different lines`,
        )
      }
      must(tape.kind(tape.length - 1) === EVENT.end, () => `${name}: no end on the tape`)
      must(landmarksOf(tape, steps).at(-1) === tape.length, () => `${name}: the end is no landmark`)
    }
  })
})
