import { quantilesOf } from '../../experiments/summary/statistics'

/** A reading this long is many ticks of a browser's clock, of which one may be 1 ms. */
const LEAST_READING_MS = 10
const READINGS = 5
/** A run that takes longer is not repeated. */
export const MOST_MS = 300

/**
 * How long `run` takes, in milliseconds: the median of 5 readings of 10 ms at least, unless those
 * would take more than 300 ms. Runs too quick for the clock are read several at a time.
 */
export function medianTime(run: () => void, now: () => number): number {
  const began = now()
  let runsAtOnce = 1
  const readings: number[] = []
  for (;;) {
    const from = now()
    for (let i = 0; i < runsAtOnce; i++) run()
    const to = now()
    const spent = to - began
    if (to - from < LEAST_READING_MS && spent < MOST_MS) {
      // The readings so far are too short for this clock.
      readings.length = 0
      runsAtOnce *= 2
      continue
    }
    readings.push((to - from) / runsAtOnce)
    if (readings.length === READINGS || spent >= MOST_MS) return quantilesOf(readings).median
  }
}
