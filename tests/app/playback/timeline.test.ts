import { describe, expect, it } from 'vitest'
import { placeOf, timelineOf, timeOfPlace } from '../../../src/app/playback/timeline'
import { EVENT, Tape } from '../../../src/index'
import { HOOK, LONGER_HOOK, shownState } from '../setups'

const timeline = timelineOf(shownState(HOOK).shown.tape)
const { steps } = timeline

it.each([
  [0, [0]],
  [1, [0, 1]],
  [2, [0, 1, 2]],
])('a tape of %d vertices is stepped through at %j', (vertices, moments) => {
  const tape = new Tape()
  tape.begin(2, 2)
  for (let cell = 0; cell < vertices; cell++) tape.write(EVENT.vertex, cell)
  const { steps, landmarks } = timelineOf(tape)
  expect([[...steps], [...landmarks]]).toEqual([moments, []])
})

describe('the place on another tape', () => {
  const other = timelineOf(shownState(LONGER_HOOK).shown.tape)

  it('is the same place on the same tape', () => {
    for (const time of steps) expect(timeOfPlace(timeline, placeOf(timeline, time))).toBe(time)
  })

  it('lies after as many landmarks and steps', () => {
    for (const time of steps.subarray(0, -1)) {
      const place = placeOf(timeline, time)
      if (place.landmarks >= other.landmarks.length) continue
      const there = placeOf(other, timeOfPlace(other, place))
      expect(there.landmarks).toBe(place.landmarks)
      const room = { landmarks: place.landmarks, steps: Number.MAX_SAFE_INTEGER }
      const most = placeOf(other, timeOfPlace(other, room)).steps
      expect(there.steps).toBe(Math.min(place.steps, most))
    }
  })

  it('is the end if there are not so many landmarks', () => {
    const short = timelineOf(shownState('S..\n...\n..G').shown.tape)
    expect(timeOfPlace(short, { landmarks: 5, steps: 2 })).toBe(short.steps.at(-1))
  })
})
