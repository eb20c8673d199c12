import { test } from 'vitest'
import { LONG, onEveryMap } from '../reference/cases'
import { classicMustHold, reportMustHold } from '../reference/tangent-bug'

// With line of sight; a file of its own so that it runs beside the other one.

test('tangent-bug classic is complete by what is in sight', { timeout: LONG }, async () => {
  await onEveryMap((world) => classicMustHold(world, true))
})

test('tangent-bug report walks as described by what is in sight', { timeout: LONG }, async () => {
  await onEveryMap((world) => reportMustHold(world, true))
})
