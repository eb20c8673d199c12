import { test } from 'vitest'
import { Tape } from '../../src/index'
import { LONG, onEveryMap } from '../reference/cases'
import { run } from '../reference/run'
import { mustLeaveWhenNearer } from '../reference/tangent-bug-boundary'

test('tangent-bug classic leaves when d_reach < d_followed', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const range = 1 + (index % 4)
    for (const turn of ['left', 'right'] as const) {
      const tape = new Tape()
      const { name } = run(world, 'tangent-bug', { variant: 'classic', range, turn }, tape)
      mustLeaveWhenNearer(name, world, tape, range, turn)
    }
  })
})
