import { expect, test } from 'vitest'
import { costOfWeight, DIAGONAL_WEIGHT } from '../../src/algorithms/costs'
import { MAX_SIDE } from '../../src/grid/grid'

/** No path has more steps. */
const MOST_STEPS = MAX_SIDE ** 2

test('a path of the largest map weighs its steps and less than one more, if each step costs 1', () => {
  expect(costOfWeight('cells', MOST_STEPS * DIAGONAL_WEIGHT.cells)).toBe(MOST_STEPS)
  expect(DIAGONAL_WEIGHT.cells).toBeGreaterThan(1)
})

test.each(Object.entries(DIAGONAL_WEIGHT))(
  'weights are summed up without rounding: %s',
  (_, weight) => {
    expect(Number.isInteger(weight * 2 ** 30)).toBe(true)
    expect(Number.isSafeInteger(MOST_STEPS * weight * 2 ** 30)).toBe(true)
  },
)

test('a diagonal step weighs √2 in all digits that a length is told with', () => {
  expect(Math.abs(DIAGONAL_WEIGHT.euclidean - Math.SQRT2)).toBeLessThan(1e-9)
})
