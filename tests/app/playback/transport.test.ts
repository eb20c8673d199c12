import { describe, expect, it } from 'vitest'
import { Moments } from '../../../src/app/playback/moment'
import { tempoOf } from '../../../src/app/playback/speeds'
import { stepAt, timelineOf } from '../../../src/app/playback/timeline'
import {
  chooseSpeed,
  jumpToStep,
  played,
  stepBack,
  stepForward,
  stepNumber,
  toFirst,
  togglePlay,
  toLandmarkBefore,
  toLast,
  toNextLandmark,
  toStep,
} from '../../../src/app/playback/transport'
import { type State, THE_END } from '../../../src/app/state/state'
import { hidePath } from '../../../src/app/state/transitions'
import { EVENT } from '../../../src/trace/events'
import { frameAt } from '../../../src/trace/fold'
import { Tape } from '../../../src/trace/tape'
import { HOOK, shownState } from '../setups'

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
    expect(toStep(hidePath(begin), 3).time).toBe(THE_END)
  })

  it('is told as the number of a step', () => {
    const last = steps.length - 1
    const numbers = [toStep(begin, 0), jumpToStep(begin, 3), begin].map(
      (state) => stepNumber(state, begin.shown).step,
    )
    expect(numbers).toEqual([0, 3, last])
    expect(stepNumber(begin, begin.shown).steps).toBe(last)
    // In the middle of a step it is that one.
    const inside = steps.findIndex((time, i) => i > 0 && time - steps[i - 1] > 1)
    const time = steps[inside] - 1
    expect(stepNumber({ ...begin, time }, begin.shown).step).toBe(inside)
  })

  it('has nowhere to go without a plan', () => {
    const hidden = hidePath(begin)
    for (const move of [stepBack, toFirst, toNextLandmark, togglePlay]) {
      expect(move(hidden)).toMatchObject({ time: THE_END, playing: null })
      expect(move(hidden).said.text).toMatch(/^There is no plan/)
    }
  })

  it('says that there is no plan yet while there may be one soon', () => {
    const hidden = hidePath(begin)
    expect(stepBack(hidden).said.text).toBe('There is no plan to step through.')
    const running: State = { ...hidden, run: { kind: 'running', slow: true, done: 0 } }
    expect(stepBack(running).said.text).toBe('There is no plan to step through yet.')
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

  it('looks for its frame as long as there is time', () => {
    const moments = new Moments()
    const isTimeUp = () => true
    expect(moments.seek(toStep(begin, 9), isTimeUp)).toBe(true)
    for (const state of [begin, hidePath(begin)]) expect(moments.seek(state, isTimeUp)).toBe(true)
    const long = new Tape()
    long.begin(7, 5)
    for (let i = 0; i < 200_000; i++) long.write(EVENT.step, i % 35)
    const shown = { ...begin.shown, tape: long, last: frameAt(long, long.length) }
    const late = { ...begin, shown, time: 190_000 }
    let tries = 1
    while (!moments.seek(late, isTimeUp)) tries++
    expect(tries).toBeGreaterThan(1)
    expect(moments.of(late)?.frame.trail.length).toBe(190_000)
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

  it('does nothing unless it goes on', () => {
    expect(played(begin, 7)).toBe(begin)
    const hidden = hidePath(togglePlay(begin))
    expect(played(hidden, 7)).toBe(hidden)
    const playing = togglePlay(begin)
    expect(played(playing, playing.time)).toBe(playing)
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
