import fc from 'fast-check'
import { expect, test } from 'vitest'
import { quantilesOf, wilson } from '../../../src/experiments/summary/statistics'

test.each([
  // Newcombe, "Two-sided confidence intervals for the single proportion", 1998, Table I.
  [81, 263, 0.2553, 0.3662],
  [15, 148, 0.0624, 0.1605],
  [0, 20, 0, 0.1611],
  [1, 29, 0.0061, 0.1718],
])('Wilson of %d of %d is from %d to %d', (successes, total, low, high) => {
  const share = wilson(successes, total)
  expect(share.rate).toBeCloseTo(successes / total, 12)
  expect(share.low).toBeCloseTo(low, 4)
  expect(share.high).toBeCloseTo(high, 4)
})

test('intervals lie around the rate, within 0 and 1, and narrow as runs are added', () => {
  fc.assert(
    fc.property(fc.nat(200), fc.nat(200), (successes, failures) => {
      fc.pre(successes + failures > 0)
      const { rate, low, high } = wilson(successes, successes + failures)
      expect(low).toBeGreaterThanOrEqual(0)
      expect(low).toBeLessThanOrEqual(rate)
      expect(high).toBeGreaterThanOrEqual(rate)
      expect(high).toBeLessThanOrEqual(1)
      const more = wilson(10 * successes, 10 * (successes + failures))
      expect(more.high - more.low).toBeLessThan(high - low)
    }),
  )
  expect(wilson(0, 0)).toEqual({ rate: Number.NaN, low: 0, high: 1 })
})

test('all and none end where shares end, without a rounding error', () => {
  for (let total = 1; total <= 300; total++) {
    expect([wilson(0, total).low, wilson(total, total).high]).toEqual([0, 1])
  }
})

test('quantiles lie between the values around them', () => {
  expect(quantilesOf([4, 1, 3, 2])).toEqual({
    least: 1,
    lower: 1.75,
    median: 2.5,
    upper: 3.25,
    high: 3.8499999999999996,
    greatest: 4,
    mean: 2.5,
  })
  expect(quantilesOf([7]).median).toBe(7)
  expect(Object.values(quantilesOf([]))).toEqual(new Array(7).fill(Number.NaN))
})
