import { describe, expect, it } from 'vitest'
import { Pace } from '../../src/app/pacing'
import { Playback } from '../../src/app/playback'
import { EVENT } from '../../src/trace/events'
import { frameAt } from '../../src/trace/frame'
import { Tape } from '../../src/trace/tape'
import { planned, setupFrom } from './setups'

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

  it('ends even if there is nothing to be seen', () => {
    expect(new Pace(tapeOf(['value', 5])).timeAt(1)).toBe(5)
    expect(new Pace(tapeOf()).timeAt(1)).toBe(0)
  })
})

describe('playback', () => {
  const shown = planned(setupFrom('S...\n.##.\n...G', 'bug2'))

  it('begins with the first frame and is over at its end', () => {
    const playback = new Playback(shown, { duration: 1000, times: 1, pause: 0 })
    expect(playback.frameAt(5000)?.time).toBe(0)
    const middle = playback.frameAt(5500)?.time ?? 0
    expect(middle).toBeGreaterThan(0)
    expect(middle).toBeLessThan(shown.tape.length)
    expect(playback.frameAt(6000)).toBeNull()
  })

  it('is repeated, with a rest at the end', () => {
    const playback = new Playback(shown, { duration: 1000, times: 2, pause: 500 })
    playback.frameAt(0)
    expect(playback.frameAt(1200)?.time).toBe(shown.tape.length)
    expect(playback.frameAt(1500)?.time).toBe(0)
    expect(playback.frameAt(2499)).not.toBeNull()
    expect(playback.frameAt(2500)).toBeNull()
  })
})
