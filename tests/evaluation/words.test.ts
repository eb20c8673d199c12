import { expect, test } from 'vitest'
import { linearScale, logScale } from '../../src/evaluation/scale'
import { list, percent, withInterval } from '../../src/evaluation/words'

test.each([
  [0, '0.0 %'],
  [0.0004, '< 0.1 %'],
  [0.0006, '0.1 %'],
  [0.5, '50.0 %'],
  [0.9994, '99.9 %'],
  [0.9996, '> 99.9 %'],
  [1, '100.0 %'],
  [Number.NaN, '–'],
])('the share %d is written as %s', (share, words) => {
  expect(percent(share)).toBe(words)
})

test('an interval is written behind its share', () => {
  expect(withInterval({ rate: 0.963, low: 0.959, high: 0.967 })).toBe('96.3 % (95.9–96.7)')
})

test.each([
  [[], ''],
  [['a'], 'a'],
  [['a', 'b', 'c'], 'a, b and c'],
])('%j is listed as "%s"', (items, words) => {
  expect(list(items)).toBe(words)
})

test('a linear scale goes from its first tick to its last', () => {
  const { place } = linearScale([2, 3, 6], 100, 0)
  expect([2, 4, 6].map(place)).toEqual([100, 50, 0])
})

test('a logarithmic scale holds its values, with ticks at 1, 2 and 5 times powers of 10', () => {
  const { place, ticks } = logScale([3, 300], 0, 100)
  expect(ticks).toEqual([5, 10, 20, 50, 100, 200])
  expect(place(3)).toBeGreaterThan(0)
  expect(place(30)).toBeCloseTo(50)
  expect(place(300)).toBeLessThan(100)
})

test('a logarithmic scale of one value has it in its middle', () => {
  expect(logScale([7, 7], 0, 100).place(7)).toBeCloseTo(50)
})
