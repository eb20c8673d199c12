import { test } from 'vitest'
import { bug2, bug2Bound } from '../reference/bug2'
import { LONG, must, onEveryMap } from '../reference/cases'
import { mustBeComplete, mustBeModest, mustNotExceed, mustWalkAlike, run } from '../reference/run'

test('bug2 walks as described; with leave closer it is complete', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    for (const turn of ['left', 'right'] as const) {
      for (const leave of ['report', 'closer'] as const) {
        const found = run(world, 'bug2', { turn, leave })
        const { name, outcome, path } = found
        const expected = bug2(world, turn, leave)
        mustWalkAlike(name, path, expected.path)
        must(outcome.status === expected.status, () => `${name}: ${outcome.status}`)
        if (leave === 'closer') mustBeComplete(world, found)
        else mustBeModest(world, found)
        mustNotExceed(bug2Bound(world, turn, leave), found)
      }
    }
  })
})
