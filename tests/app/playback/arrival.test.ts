import { describe, expect, it } from 'vitest'
import { cursorOn, endWelcome } from '../../../src/app/playback/arrival'
import { WELCOME } from '../../../src/app/playback/speeds'
import { placeOf, timelineOf } from '../../../src/app/playback/timeline'
import {
  played,
  stepBack,
  stepForward,
  toFirst,
  togglePlay,
  toLast,
  toNextLandmark,
  toStep,
} from '../../../src/app/playback/transport'
import { type State, THE_END } from '../../../src/app/state/state'
import {
  change,
  changeMap,
  edit,
  planArrived,
  planStarted,
} from '../../../src/app/state/transitions'
import { HOOK, LONGER_HOOK, planned, setupFrom, shownState } from '../setups'

const begin = shownState(HOOK)
const { steps } = timelineOf(begin.shown.tape)

describe('a new plan', () => {
  const longer = shownState(LONGER_HOOK).setup
  const arrive = (state: State, setup = longer) =>
    planArrived(planStarted(edit(state, setup)), planned(setup), WELCOME)

  it('is played if the cursor was at the end', () => {
    expect(arrive(begin)).toMatchObject({ time: 0, playing: WELCOME, kept: null })
    const atOnce = planArrived(edit(begin, longer), planned(longer), null)
    expect(atOnce).toMatchObject({ time: THE_END, playing: null })
  })

  it('keeps the place of a cursor in the middle', () => {
    const hit = toNextLandmark(toFirst(begin))
    const state = arrive(stepForward(stepForward(hit)))
    const there = timelineOf(planned(longer).tape)
    expect(placeOf(there, state.time)).toEqual({ landmarks: 1, steps: 2 })
    expect(state.playing).toBeNull()
  })

  it('keeps the place where the cursor was put, whatever plans come in between', () => {
    const put = stepBack(toLast(begin))
    const free = setupFrom('S......\n.......\n.......\n.......\n......G', 'bug2')
    const between = arrive(put, free)
    expect(between.time).toBe(THE_END)
    expect(arrive(between, begin.setup).time).toBe(put.time)
    const moved = toFirst(between)
    expect(arrive(moved, begin.setup).time).toBe(0)
  })

  it('goes on being played from the same place', () => {
    const playing = played(togglePlay(toFirst(begin)), steps[4])
    const state = arrive(playing)
    expect(state.playing).toBe(playing.playing)
    expect(state.time).toBeLessThan(THE_END)
  })

  it('of another planner or on another map is seen to its end', () => {
    const middle = toStep(begin, 4)
    expect(arrive(middle, { ...longer, plannerId: 'bug1' })).toMatchObject({ playing: WELCOME })
    const opened = changeMap(middle, longer, 'Opened.')
    expect(cursorOn(opened, planned(longer), WELCOME)).toMatchObject({ playing: WELCOME })
  })

  it('comes to its end at once when the next edit begins', () => {
    const welcomed = arrive(begin)
    const edited = change(welcomed, begin.setup, 'Erased.')
    expect(edited).toMatchObject({ time: THE_END, playing: null })
    expect(endWelcome(begin)).toBe(begin)
  })
})
