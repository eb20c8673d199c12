import { describe, expect, test } from 'vitest'
import { emptyGrid } from '../../src/grid/grid'
import { InputError, type PlanOptions, type Problem, plan } from '../../src/index'

// Progress is told every 65,536 cells.
const grid = emptyGrid(300, 300)
const problem: Problem = { grid, start: 0, goal: 89_999, diagonal: 'only-when-no-obstacles' }
const broken = (progress: () => void) => () => plan(problem, 'decomposition', { progress })

describe('searches share their memory', () => {
  test('so there is no plan within a plan, rather than two wrong ones', () => {
    expect(broken(() => plan(problem, 'bug1'))).toThrow(InputError)
    expect(broken(() => plan(problem, 'bug1'))).toThrow('Another plan is under way')
  })

  test('and the plan after one that was broken off is right', () => {
    const before = plan(problem, 'decomposition')
    const stop = () => {
      throw new Error('That is enough.')
    }
    expect(broken(stop)).toThrow('That is enough.')
    expect(plan(problem, 'decomposition')).toEqual(before)
  })
})

test.each([
  [Number.NaN, 'NaN is no number'],
  [Number.POSITIVE_INFINITY, 'Infinity is no number'],
  [5n, '5 is no number'],
  ['5', '"5" is no number'],
])('a parameter that does not fit is told as it is: %s', (range, message) => {
  const options = { params: { range } } as PlanOptions
  expect(() => plan(problem, 'tangent-bug', options)).toThrow(InputError)
  expect(() => plan(problem, 'tangent-bug', options)).toThrow(message)
})
