import { test } from 'vitest'
import { LONG, onEveryMap } from '../reference/cases'
import { classicMustHold, reportMustHold } from '../reference/tangent-bug'

test('tangent-bug classic is complete', { timeout: LONG }, async () => {
  await onEveryMap((world) => classicMustHold(world, false))
})

test('tangent-bug report walks as described and ends', { timeout: LONG }, async () => {
  await onEveryMap((world) => reportMustHold(world, false))
})
