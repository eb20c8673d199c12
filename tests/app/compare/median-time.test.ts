import { describe, expect, it } from 'vitest'
import { medianTime } from '../../../src/app/compare/median-time'

/** Times work that takes as long as `durations` say, in turn, by a clock of the given resolution. */
function timed(durations: readonly number[], tick = 0.1) {
  let time = 0
  let runs = 0
  const run = () => {
    time += durations[runs % durations.length]
    runs++
  }
  const milliseconds = medianTime(run, () => Math.floor(time / tick) * tick)
  return { milliseconds, runs, time }
}

describe('the median time', () => {
  it('is that of five runs at least, and not moved by one that was held up', () => {
    expect(timed([10, 10, 90, 10, 10])).toEqual({ milliseconds: 10, runs: 5, time: 130 })
  })

  it('is of readings of 10 ms at least', () => {
    // 1, 2 and 4 runs are too short.
    expect(timed([2]).runs).toBe(7 + 5 * 8)
  })

  it('takes no more than 300 ms and a run', () => {
    expect(timed([100]).runs).toBe(3)
    expect(timed([1000]).runs).toBe(1)
  })

  it('reads runs that are quicker than the clock several at a time', () => {
    const { milliseconds, time } = timed([0.004])
    expect(milliseconds).toBeCloseTo(0.004, 3)
    expect(milliseconds).toBeGreaterThan(0.0035)
    expect(time).toBeLessThan(120)
  })

  it.each([0.03, 0.047, 0.09, 0.7, 1.4])('is right by a clock of whole ms: %d ms', (duration) => {
    const { milliseconds } = timed([duration], 1)
    expect(Math.abs(milliseconds / duration - 1)).toBeLessThan(0.1)
  })
})
