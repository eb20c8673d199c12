import { expect, test } from 'vitest'
import { EVENT, frameAt, plan, Tape } from '../../src/index'
import { explain } from '../../src/trace/explain'

// All pairs of an empty map are joined: more than two million edges.
const samples = 2100
const problem = {
  grid: { width: 60, height: 60, walls: new Uint8Array(3600) },
  start: 0,
  goal: 3599,
  diagonal: 'if-at-most-one-obstacle',
} as const

test('a tape with too many edges is cut, says so, and the plan is the same', () => {
  const tape = new Tape()
  const shares: number[] = []
  const progress = (done: number) => shares.push(done)
  const options = { params: { samples } }
  const outcome = plan(problem, 'probabilistic-roadmap', { ...options, tape, progress })
  const cut = tape.findLast(tape.length, 0, 3599, (i) => tape.kind(i) === EVENT.cut)
  expect(tape.length).toBeLessThan(2_100_000)
  expect(cut).toBeGreaterThan(2_000_000)
  expect(explain(tape, cut, frameAt(tape, cut + 1), [])).toMatch(
    /^There are more than 2,00\d,\d{3} edges/,
  )
  const unrecorded: number[] = []
  const without = { ...options, progress: (done: number) => unrecorded.push(done) }
  expect(outcome).toEqual(plan(problem, 'probabilistic-roadmap', without))
  expect(unrecorded.at(-1)).toBeGreaterThan(0.5)

  expect(shares.length).toBeGreaterThan(20)
  expect(shares).toEqual(shares.toSorted((a, b) => a - b))
  expect(shares[0]).toBeGreaterThanOrEqual(0)
  expect(shares.at(-1)).toBeLessThanOrEqual(1)
})
