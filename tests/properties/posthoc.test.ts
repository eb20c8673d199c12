import { test } from 'vitest'
import { planners, Tape } from '../../src/index'
import { LONG, onEveryMap } from '../reference/cases'
import { Dice } from '../reference/random'
import { anySettings } from '../reference/settings'
import { problemOf } from '../reference/world'
import { checkedTrace } from '../trace/posthoc-checks'

test('every run is a sound trace for Posthoc', { timeout: LONG }, async () => {
  const tape = new Tape()
  await onEveryMap((world, index) => {
    // The traces are long to check, and differ less than the maps do.
    if (index % 80 !== 0) return
    const dice = new Dice(11, index)
    for (const planner of planners) {
      const params = anySettings(planner.params, dice)
      try {
        checkedTrace(problemOf(world), planner, tape, { params })
      } catch (fault) {
        throw new Error(`${planner.id} ${JSON.stringify(params)}: ${fault}`, { cause: fault })
      }
    }
  })
})
