import { expect, it } from 'vitest'
import { potentialLabel } from '../../src/render/potential-label'

it.each([
  [0, '0'],
  [7, '7'],
  [55.213, '55.2'],
  [99.96, '100'],
  [949.6, '950'],
  [5002, '5002'],
  [9999.7, '10k'],
  [18_050, '18k'],
  [999_700, '1M'],
  [8_380_418, '8.4M'],
  [Number.POSITIVE_INFINITY, ''],
  [Number.NaN, ''],
])('writes %d as "%s"', (potential, label) => {
  expect(potentialLabel(potential)).toBe(label)
})
