import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { exponentOf } from '../../bench/planners/growth'
import { figuresOf, isMet, timeAlone, timeInTurn } from '../../bench/planners/timing'

/** A clock that only work moves on. */
let now = 0
beforeEach(() => {
  now = 0
  vi.spyOn(performance, 'now').mockImplementation(() => now)
})
afterEach(() => {
  vi.restoreAllMocks()
})

const turns: string[] = []
const work = (name: string, ms: number, units: number) => () => {
  turns.push(name)
  now += ms
  return units
}

test('work is timed in turn, ours first, by the units that it did', () => {
  turns.length = 0
  const { ours, peer } = timeInTurn(work('ours', 30, 1), work('peer', 120, 4))
  expect(ours.length).toBe(peer.length)
  expect(ours.length).toBeGreaterThanOrEqual(5)
  expect(new Set([...ours, ...peer])).toEqual(new Set([30]))
  // Warming up: at least 100 ms and three times each. Beside long work, both are warmed up again for
  // each sample.
  const warmUp = ['ours', 'ours', 'ours', 'ours', 'peer', 'peer', 'peer']
  const round = [...Array(4 + 1).fill('ours'), ...Array(3 + 1).fill('peer')]
  expect(turns).toEqual([...warmUp, ...ours.flatMap(() => round)])
})

test('very short work is repeated within a sample, very long work is done three times', () => {
  turns.length = 0
  const short = timeInTurn(work('ours', 0.5, 1), work('peer', 2, 1))
  expect(new Set(short.ours)).toEqual(new Set([0.5]))
  expect(short.ours).toHaveLength(15)
  const count = (name: string) => turns.filter((turn) => turn === name).length
  expect([count('ours'), count('peer')]).toEqual([200 + 15 * 20, 50 + 15 * 5])
  turns.length = 0
  expect(timeInTurn(work('ours', 101, 1), work('peer', 5000, 1)).peer).toHaveLength(3)
  expect([count('ours'), count('peer')]).toEqual([3 + 3 * (3 + 1), 1 + 3])
})

test('where little is between the two, ten times as many samples are taken', () => {
  expect(timeInTurn(work('ours', 5, 1), work('peer', 5, 1), true).ours).toHaveLength(150)
})

test('work is warmed up until it becomes no faster', () => {
  turns.length = 0
  const compiled = () => {
    turns.push('ours')
    now += turns.length > 8 ? 1 : 200 / turns.length
    return 1
  }
  for (const time of timeInTurn(compiled, work('peer', 5, 1)).ours) expect(time).toBeCloseTo(1, 9)
})

test('work by itself is timed by its units, too, and once if it is long', () => {
  turns.length = 0
  expect(timeAlone(work('long', 900, 0.5))).toBe(1800)
  expect(turns).toHaveLength(2)
  expect(timeAlone(work('short', 3, 2))).toBe(1.5)
})

test('a ratio is the median of the pairs, the way round that the target has it', () => {
  const samples = { ours: [1, 2, 4], peer: [10, 60, 80] }
  expect(figuresOf({ atLeast: 20 }, samples)).toEqual({
    ours: 2,
    peer: 60,
    ratio: 20,
    lower: 15,
    upper: 25,
    met: true,
  })
  expect(figuresOf({ atMost: 0.04 }, samples)).toMatchObject({ ratio: 0.05, met: false })
  expect(figuresOf(null, samples)).toMatchObject({ ratio: 20, met: true })
})

test('a target is met at its own value', () => {
  expect(isMet({ atLeast: 12 }, 12)).toBe(true)
  expect(isMet({ atLeast: 12 }, 11.99)).toBe(false)
  expect(isMet({ atMost: 3 }, 3)).toBe(true)
  expect(isMet({ atMost: 3 }, 3.01)).toBe(false)
})

test('the exponent is that of the power of the cells', () => {
  const sides = [64, 128, 256, 512]
  const points = (time: (cells: number) => number) =>
    sides.map((side) => ({ side, median: time(side * side) }))
  expect(exponentOf(points((cells) => 3 * cells))).toBeCloseTo(1, 10)
  expect(exponentOf(points((cells) => cells ** 1.5 / 7))).toBeCloseTo(1.5, 10)
  expect(exponentOf(points(() => 0.2))).toBeCloseTo(0, 10)
})
