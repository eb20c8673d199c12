import { describe, expect, it } from 'vitest'
import { Pace } from '../../../src/app/playback/pacing'
import { Playback } from '../../../src/app/playback/playback'
import { timelineOf } from '../../../src/app/playback/timeline'
import { EVENT } from '../../../src/trace/events'
import { frameAt } from '../../../src/trace/fold'
import { Tape } from '../../../src/trace/tape'
import { planned, setupFrom } from '../setups'

function tapeOf(...kinds: readonly (readonly [keyof typeof EVENT, number])[]): Tape {
  const tape = new Tape()
  tape.begin(10, 10)
  for (const [kind, times] of kinds) {
    for (let i = 0; i < times; i++) tape.write(EVENT[kind], i % 100)
  }
  return tape
}

describe('the pace', () => {
  it('gives a long search and a short path about the same time', () => {
    const pace = new Pace(tapeOf(['open', 990], ['path', 10]))
    const half = pace.timeAt(0.5)
    expect(half).toBeGreaterThan(980)
    expect(half).toBeLessThan(996)
    expect(pace.timeAt(0.9)).toBeGreaterThan(half)
    expect(pace.timeAt(1)).toBe(1000)
  })

  it('moves a rover evenly, however much it senses on the way', () => {
    const tape = tapeOf(['step', 1], ['sense', 60], ['step', 1], ['sense', 3], ['step', 2])
    const pace = new Pace(tape)
    const steps = [0.2, 0.45, 0.7, 0.95].map(
      (share) => frameAt(tape, pace.timeAt(share)).trail.length,
    )
    expect(steps).toEqual([1, 2, 3, 4])
  })

  it('spends all of its time on the search if nothing comes out of it', () => {
    const pace = new Pace(tapeOf(['open', 100]))
    expect(pace.timeAt(0.5)).toBeGreaterThanOrEqual(49)
    expect(pace.timeAt(0.5)).toBeLessThanOrEqual(51)
  })

  it.each([
    'row',
    'test',
    'vertex',
    'edge',
    'refuse',
    'open',
    'close',
    'attraction',
    'repulsion',
    'potential',
  ] as const)('counts %s as search, as long as the walk after it', (kind) => {
    const pace = new Pace(tapeOf([kind, 100], ['step', 10]))
    expect(pace.timeAt(0.4)).toBeLessThan(100)
    expect(pace.timeAt(0.5)).toBeGreaterThan(100)
    expect(pace.timeAt(0.5)).toBeLessThan(103)
  })

  it('is begun anywhere', () => {
    const tape = tapeOf(['open', 100], ['path', 10])
    const pace = new Pace(tape)
    const share = pace.beginAt(50)
    expect(share).toBeCloseTo(0.225)
    expect(pace.timeAt(share)).toBe(50)
    expect(pace.timeAt(1)).toBe(110)
  })

  it('ends even if there is nothing to be seen', () => {
    expect(new Pace(tapeOf(['value', 5])).timeAt(1)).toBe(5)
    expect(new Pace(tapeOf()).timeAt(1)).toBe(0)
  })
})

describe('playing a tape', () => {
  const { tape } = planned(setupFrom('S...\n.##.\n...G', 'bug2'))
  const { steps } = timelineOf(tape)
  const whole = { kind: 'whole', duration: 1000, times: 1, pause: 0, asked: true } as const
  const THE_END = Number.POSITIVE_INFINITY

  it('as a whole begins with the first event and is over after the last', () => {
    const playback = new Playback({ tape, tempo: whole, time: 0 })
    expect(playback.timeAt(5000)).toBe(0)
    const middle = playback.timeAt(5500)
    expect(middle).toBeGreaterThan(0)
    expect(middle).toBeLessThan(tape.length)
    expect(playback.timeAt(6000)).toBe(THE_END)
  })

  it('as a whole goes on from where it was, in the time that is left', () => {
    const middle = new Playback({ tape, tempo: whole, time: 0 })
    middle.timeAt(0)
    const time = middle.timeAt(500)
    const playback = new Playback({ tape, tempo: whole, time })
    expect(playback.timeAt(0)).toBe(time)
    expect(playback.timeAt(300)).toBeGreaterThan(time)
    expect(playback.timeAt(300)).toBeLessThan(tape.length)
    expect(playback.timeAt(520)).toBe(THE_END)
  })

  it('is repeated, with a rest at the end', () => {
    const playback = new Playback({ tape, tempo: { ...whole, times: 2, pause: 500 }, time: 0 })
    playback.timeAt(0)
    expect(playback.timeAt(1200)).toBe(tape.length)
    expect(playback.timeAt(1500)).toBe(0)
    expect(playback.timeAt(2499)).toBeLessThanOrEqual(tape.length)
    expect(playback.timeAt(2500)).toBe(THE_END)
  })

  it('by steps takes the first at once and the others at its speed', () => {
    const playback = new Playback({ tape, tempo: { kind: 'steps', perSecond: 2 }, time: steps[3] })
    const times = [0, 499, 500, 999, 1000].map((now) => playback.timeAt(7000 + now))
    expect(times).toEqual([4, 4, 5, 5, 6].map((step) => steps[step]))
    // The fourth step is taken at once, so the last one after as many halves of a second less four.
    const last = steps.length - 1
    const atEnd = [last - 1, last].map((step) => playback.timeAt(7000 + 500 * (step - 4)))
    expect(atEnd).toEqual([steps[last - 1], THE_END])
  })

  it('by steps goes on after the step that it is in the middle of', () => {
    const inside = steps.findIndex((time, i) => i > 0 && time - steps[i - 1] > 1)
    const time = steps[inside] - 1
    const playback = new Playback({ tape, tempo: { kind: 'steps', perSecond: 1 }, time })
    expect(playback.timeAt(0)).toBe(steps[inside + 1])
  })

  it('knows when someone else has moved the cursor', () => {
    const playback = new Playback({ tape, tempo: whole, time: 0 })
    const time = playback.timeAt(0)
    expect(playback.isPlaying({ tape, tempo: whole, time })).toBe(true)
    expect(playback.isPlaying({ tape, tempo: whole, time: time + 1 })).toBe(false)
    expect(playback.isPlaying({ tape, tempo: { ...whole }, time })).toBe(false)
  })
})

it('a long tape is played in more frames, not in longer ones', () => {
  const tape = tapeOf(['close', 1_000_000])
  const tempo = { kind: 'whole', duration: 1, times: 1, pause: 0, asked: true } as const
  const playback = new Playback({ tape, tempo, time: 0 })
  const times: number[] = []
  for (let now = 0; times.at(-1) !== Number.POSITIVE_INFINITY; now += 16) {
    times.push(playback.timeAt(now))
  }
  const strides = times.slice(1, -1).map((time, i) => time - times[i])
  expect(strides.length).toBeGreaterThan(5)
  expect(Math.max(...strides)).toBeLessThan(150_000)
})
