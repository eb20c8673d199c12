import { expect, test } from 'vitest'
import { shorter, wayOver } from '../../src/algorithms/sensed-square'
import { plan, problemFromText } from '../../src/index'

test('blocked at a place again, the rover goes on if it knows more than before', () => {
  const problem = problemFromText(`
    S..#G
    ...#.
    ...#.
    ...#.
    .....
    #####
    ...#.`)
  for (const lineOfSight of [false, true]) {
    expect(plan(problem, 'tangent-bug', { params: { lineOfSight } }).status).toBe('reached')
  }
})

test('of ways over places on one straight line the first is taken, however roots are rounded', () => {
  let roundings = 0
  for (let x = 1; x < 10; x++) {
    for (let y = 0; y <= x; y++) {
      const ends = { position: { x: 0, y: 0 }, goal: { x: 3 * x, y: 3 * y } }
      const ways = [1, 2, 3].map((times) => wayOver(ends, { x: times * x, y: times * y }))
      for (const first of ways)
        for (const second of ways) expect(shorter(first, second)).toBe(first)
      if (new Set(ways.map(({ length }) => length)).size > 1) roundings++
    }
  }
  expect(roundings).toBeGreaterThan(0)
})
