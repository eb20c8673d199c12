import { describe, expect, it } from 'vitest'
import { cursorOn, endWelcome } from '../../src/app/arrival'
import { Moments } from '../../src/app/moment'
import { tempoOf, WELCOME } from '../../src/app/speeds'
import { type Shown, type State, THE_END } from '../../src/app/state'
import { placeOf, stepAt, timelineOf, timeOfPlace } from '../../src/app/timeline'
import {
  change,
  changeMap,
  edit,
  hidePath,
  planArrived,
  planStarted,
} from '../../src/app/transitions'
import {
  chooseSpeed,
  played,
  stepBack,
  stepForward,
  toFirst,
  togglePlay,
  toLandmarkBefore,
  toLast,
  toNextLandmark,
  toStep,
} from '../../src/app/transport'
import { frameAt } from '../../src/trace/fold'
import { planned, setupFrom, stateFrom } from './setups'

const HOOK = ['S......', '.####..', '....#..', '.####..', '......G'].join('\n')
/** The same with one more obstacle, far from where the first landmarks are. */
const LONGER_HOOK = ['S......', '.####..', '....#..', '.#####.', '......G'].join('\n')

/** A plan on screen. */
function shownState(text: string, plannerId = 'bug2'): State & { readonly shown: Shown } {
  const setup = setupFrom(text, plannerId)
  const shown = planned(setup)
  return { ...planArrived({ ...stateFrom(text), setup, committed: setup }, shown), shown }
}

const begin = shownState(HOOK)
const { tape } = begin.shown
const timeline = timelineOf(tape)
const { steps, landmarks } = timeline

describe('the cursor on the tape', () => {
  it('begins at the end', () => {
    expect(begin.time).toBe(THE_END)
  })

  it('goes by steps, forwards and backwards', () => {
    let state: State = toFirst(begin)
    for (const time of steps.subarray(1, -1)) {
      state = stepForward(state)
      expect(state.time).toBe(time)
    }
    state = stepForward(state)
    expect(state.time).toBe(THE_END)
    expect(stepForward(state).time).toBe(THE_END)
    for (const time of [...steps.subarray(0, -1)].reverse()) {
      state = stepBack(state)
      expect(state.time).toBe(time)
    }
    expect(stepBack(state).time).toBe(0)
  })

  it('goes by landmarks', () => {
    let state: State = toFirst(begin)
    for (const time of landmarks.subarray(0, -1)) {
      state = toNextLandmark(state)
      expect(state.time).toBe(time)
    }
    expect(toNextLandmark(state).time).toBe(THE_END)
    for (const time of [...landmarks.subarray(0, -2)].reverse()) {
      state = toLandmarkBefore(state)
      expect(state.time).toBe(time)
    }
    expect(toLandmarkBefore(state).time).toBe(0)
  })

  it('goes to the step of a number, and no further than there are', () => {
    expect(toStep(begin, 3).time).toBe(steps[3])
    expect(toStep(begin, 1e6).time).toBe(THE_END)
    expect(toStep(begin, -1).time).toBe(0)
    expect(stepAt(timeline, steps[3])).toBe(3)
  })

  it('has nowhere to go without a plan', () => {
    const hidden = hidePath(begin)
    for (const move of [stepBack, toFirst, toNextLandmark, togglePlay]) {
      expect(move(hidden)).toMatchObject({ time: THE_END, playing: null })
      expect(move(hidden).said.text).toMatch(/^There is no plan/)
    }
  })

  it('shows the frame that belongs to it', () => {
    const moments = new Moments()
    const shown = [toFirst(begin), toStep(begin, 9), toStep(begin, 4), begin].map(
      (state) => moments.of(state)?.frame.trail.length,
    )
    const expected = [0, steps[9], steps[4], tape.length].map((t) => frameAt(tape, t).trail.length)
    expect(shown).toEqual(expected)
    expect(moments.of(begin)?.frame).toBe(begin.shown.last)
    expect(moments.of(hidePath(begin))).toBeNull()
  })
})

describe('playing', () => {
  it('starts anew at the end, and else goes on from where it is', () => {
    expect(togglePlay(begin)).toMatchObject({ time: 0, playing: tempoOf(5) })
    const middle = toStep(begin, 4)
    expect(togglePlay(middle)).toMatchObject({ time: steps[4], playing: tempoOf(5) })
  })

  it('leaves the cursor where it is stopped', () => {
    const stopped = togglePlay(played(togglePlay(begin), 7))
    expect(stopped).toMatchObject({ time: 7, playing: null })
  })

  it('ends at the end', () => {
    const playing = togglePlay(begin)
    for (const time of [tape.length, THE_END]) {
      expect(played(playing, time)).toMatchObject({ time: THE_END, playing: null })
    }
  })

  it('stops when the cursor is moved by hand', () => {
    for (const move of [stepForward, stepBack, toLast, toNextLandmark]) {
      expect(move(togglePlay(begin)).playing).toBeNull()
    }
  })

  it('goes on at another speed', () => {
    const playing = played(togglePlay(begin), 7)
    expect(chooseSpeed(playing, 30)).toMatchObject({ time: 7, playing: tempoOf(30) })
    expect(chooseSpeed(begin, 'moment').playing).toBeNull()
    expect(togglePlay(chooseSpeed(begin, 'moment')).playing).toEqual(tempoOf('moment'))
  })
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
