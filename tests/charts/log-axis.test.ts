import { expect, test } from 'vitest'
import type { Mark } from '../../src/charts/chart'
import { frameOf, logTicks } from '../../src/charts/log-axis'

const mark = (y: number, high: number): Mark => ({
  series: 0,
  x: 1,
  y,
  low: 0,
  high,
  label: '',
  runs: [],
})

test('the frame holds all marks, and the upper ends of their intervals', () => {
  const [least, greatest] = frameOf([mark(0.4, 2), mark(3, 90)])
  expect(least).toBeGreaterThan(0)
  expect(least).toBeLessThan(0.4)
  expect(greatest).toBeGreaterThan(90)
  expect(frameOf([])).toEqual([1, 10])
})

test.each([
  [0.0012, 52, [0.01, 0.1, 1, 10]],
  [1, 100, [1, 10, 100]],
  [0.5, 1.3, [0.5, 1]],
  [0.15, 0.78, [0.2, 0.5]],
  [2.1, 5.5, [5]],
])('an axis from %d to %d has numbers', (least, greatest, ticks) => {
  expect(logTicks([least, greatest])).toEqual(ticks)
})
