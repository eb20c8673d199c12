import { test } from 'vitest'
import { EVENT, Tape as NewTape, type ParamSettings, type Tape } from '../../src/index'
import { landmarksOf, stepsOf } from '../../src/trace/landmarks'
import { bug1, type Walk } from '../reference/bug1'
import { bug2 } from '../reference/bug2'
import { LONG, must, onEveryMap } from '../reference/cases'
import { run, show } from '../reference/run'
import type { World, XY } from '../reference/world'

/** The places of the landmarks of one kind, in the order in which the player meets them. */
function landmarkPlaces(world: World, tape: Tape, kind: number): XY[] {
  const steps = stepsOf(tape)
  const places: XY[] = []
  for (const moment of landmarksOf(tape, steps)) {
    const first = steps[steps.indexOf(moment) - 1]
    const cell = tape.cell(first)
    if (tape.kind(first) === kind) {
      places.push([cell % world.width, Math.floor(cell / world.width)])
    }
  }
  return places
}

function mustHaveLandmarks(world: World, id: string, params: ParamSettings, walk: Walk): void {
  const tape = new NewTape()
  const { name } = run(world, id, params, tape)
  for (const [kind, expected] of [
    [EVENT.hit, walk.hits],
    [EVENT.leave, walk.leaves],
  ] as const) {
    const found = landmarkPlaces(world, tape, kind)
    must(
      show(found) === show(expected),
      () => `${name}: landmarks ${show(found)}, but should be ${show(expected)}`,
    )
  }
}

test('the landmarks of Bug1 and Bug2 are their hit and leave points', {
  timeout: LONG,
}, async () => {
  await onEveryMap((world, index) => {
    const turn = index % 2 === 0 ? 'left' : 'right'
    mustHaveLandmarks(world, 'bug1', { turn }, bug1(world, turn))
    for (const leave of ['report', 'closer'] as const) {
      mustHaveLandmarks(world, 'bug2', { turn, leave }, bug2(world, turn, leave))
    }
  })
})
