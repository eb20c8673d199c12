import { test } from 'vitest'
import { boundarySteps } from '../reference/boundary'
import { bug1 } from '../reference/bug1'
import { LONG, must, onEveryMap } from '../reference/cases'
import { mustBeComplete, mustNotExceed, mustWalkAlike, run } from '../reference/run'
import { freeCells } from '../reference/world'

/*
 * The bound. Each place on the way to the goal is nearer to it than all places on the way before,
 * hit and leave points included, so that all of them together are at most the free cells. Each
 * boundary's directed steps form one ring, and after going around it the rover leaves from its
 * nearest place: it meets that ring again only if it is refused right there, and then the second
 * round finds nothing nearer and is the last. Going back takes at most half a round. So all rounds
 * together are at most one and a half times all boundary steps, and once more the last ring.
 */
test('bug1 walks as described and is complete', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    for (const turn of ['left', 'right'] as const) {
      const found = run(world, 'bug1', { turn })
      const { name, outcome, path } = found
      const expected = bug1(world, turn)
      mustWalkAlike(name, path, expected.path)
      must(outcome.status === expected.status, () => `${name}: ${outcome.status}`)
      mustBeComplete(world, found)
      mustNotExceed(freeCells(world).length - 1 + 2.5 * boundarySteps(world, turn), found)
    }
  })
})
