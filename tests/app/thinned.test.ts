import { describe, expect, it } from 'vitest'
import { planners } from '../../src/algorithms/planners'
import type { Moment } from '../../src/app/playback/moment'
import { timelineOf } from '../../src/app/playback/timeline'
import type { Shown } from '../../src/app/state/state'
import { stepNumbers } from '../../src/app/words/step-numbers'
import { stepInWords } from '../../src/app/words/steps-in-words'
import { leftOut } from '../../src/app/words/thinning'
import { foldWhole } from '../../src/trace/checkpoints'
import { frameAt } from '../../src/trace/fold'
import { Tape } from '../../src/trace/tape'
import { written } from '../trace/written'
import { planned, setupFrom } from './setups'

const MAP = 'S....\n.##..\n.#...\n...#.\n.#..G'

/** A plan on a tape that leaves out small events. */
function thinnedPlan(id: string): Shown {
  const whole = planned(setupFrom(MAP, id))
  const { width, height, diagonalCost, length } = whole.tape
  const empty = { width, height, diagonalCost, length: 0, words: [], values: [], buffers: [] }
  const tape = Tape.from({ ...empty, thinning: 'thinned' })
  for (const { kind, line, cell, other, value } of written(whole.tape)) {
    tape.at(line).write(kind, cell, other, value)
  }
  expect(tape.length).toBeLessThan(length)
  return { ...whole, tape, ...foldWhole(tape) }
}

describe('a thinned tape', () => {
  const ids = planners.map(({ id }) => id)
  const whole = planners.filter(({ family }) => family === 'offline').map(({ id }) => id)

  it.each(ids)('of %s has a sentence and numbers for each of its steps', (id) => {
    const shown = thinnedPlan(id)
    const { steps } = timelineOf(shown.tape)
    expect(steps.length).toBeGreaterThan(2)
    for (const time of steps) {
      const moment: Moment = { shown, frame: frameAt(shown.tape, time) }
      const { open, closed } = moment.frame
      // Cells that are closed tell of others that are open; vertices leave it to events of their own.
      if (id === 'decomposition') expect(open).toBeGreaterThanOrEqual(0)
      else expect(open).toBe(0)
      expect(closed).toBeGreaterThanOrEqual(0)
      const sentence = stepInWords(moment)
      expect(sentence).not.toMatch(/undefined|NaN|keeping|on the (left|right)|No end|^$/)
      const rows = stepNumbers(moment)
      const boundary = rows.find(({ label }) => label === 'Boundary')?.value
      const told = moment.frame.following ? 'followed' : 'not followed'
      expect(boundary).toBe(whole.includes(id) ? undefined : told)
      expect(rows.map(({ label }) => label)).not.toContain('Open')
      expect(rows.map(({ value }) => value).join()).not.toMatch(/undefined|NaN|on the/)
      // What is not on the tape has no row: at the end all of them have a value.
      if (time === shown.tape.length) expect(rows.map(({ value }) => value)).not.toContain('–')
    }
  })

  it('says that it is', () => {
    expect(leftOut('whole').words).toBe('')
    expect(leftOut('thinned').words).toMatch(/^This plan is too long .* Small things are left out/)
    expect(leftOut('cut').words).toMatch(/to its end/)
  })
})
