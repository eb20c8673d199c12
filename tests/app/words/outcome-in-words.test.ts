import { describe, expect, it } from 'vitest'
import type { Outcome } from '../../../src/algorithms/plan'
import { timeInWords } from '../../../src/app/words/numbers'
import {
  outcomeInWords,
  outcomeNumbers,
  reasonInWords,
  toneOf,
} from '../../../src/app/words/outcome-in-words'

const WIDTH = 10

const outcome = (some: Partial<Outcome>): Outcome => ({
  status: 'reached',
  reason: 'the rover is at the goal',
  path: Int32Array.of(30, 31, 32),
  cost: 2,
  measure: { cells: 3, length: 2, turns: 0 },
  expanded: 0,
  sensed: 0,
  ...some,
})

describe('the words for an outcome', () => {
  it.each([
    [{}, 'Reached in 3 cells'],
    [{ path: Int32Array.of(7) }, 'Reached in 1 cell'],
    [{ path: new Int32Array(1234) }, 'Reached in 1,234 cells'],
    [
      { status: 'unreachable', reason: 'went round the obstacle once' },
      'Proven unreachable: went round the obstacle once',
    ],
    [
      { status: 'loop', reason: 'same place, same state as step 41' },
      'Loop: same place, same state as step 41',
    ],
    [{ status: 'not-found', reason: 'too few samples' }, 'No path found: too few samples'],
    [
      { status: 'local-minimum', path: Int32Array.of(30, 36) },
      'Stuck in a local minimum at (6, 3)',
    ],
    [{ status: 'dead-end', path: Int32Array.of(30, 99) }, 'Dead end at (9, 9)'],
    [{ status: 'local-minimum', path: new Int32Array(0) }, 'Stuck in a local minimum'],
  ] as const)('%o: %s', (some, words) => {
    expect(outcomeInWords(outcome(some), WIDTH)).toBe(words)
  })

  it('tell the reason once: in the words or after them', () => {
    expect(reasonInWords(outcome({}))).toBe('The rover is at the goal.')
    expect(reasonInWords(outcome({ status: 'loop' }))).toBe('')
  })

  it('have a tone of their own for good news, for a proof, and for giving up', () => {
    expect(toneOf('reached')).toBe('good')
    expect(toneOf('unreachable')).toBe('proof')
    for (const status of ['not-found', 'local-minimum', 'dead-end', 'loop'] as const) {
      expect(toneOf(status)).toBe('bad')
    }
  })
})

describe('the numbers of an outcome', () => {
  const valuesOf = (...given: Parameters<typeof outcomeNumbers>) =>
    Object.fromEntries(outcomeNumbers(...given).map(({ label, value }) => [label, value]))

  it('count what a search expanded', () => {
    const measure = { cells: 3, length: 1 + Math.SQRT2, turns: 1 }
    expect(valuesOf(outcome({ measure, expanded: 2048 }), 3.14, 'offline')).toEqual({
      'Time to plan': '3.1 ms',
      Path: '3 cells',
      'Euclidean length': '2.41',
      Turns: '1',
      Expanded: '2,048',
    })
  })

  it('count what a rover sensed, and say that it has not arrived', () => {
    expect(valuesOf(outcome({ status: 'loop', sensed: 130 }), 0, 'online')).toMatchObject({
      'Walked so far': '3 cells',
      Sensed: '130 cells',
    })
  })

  it('say nothing of a path that is not there', () => {
    const none = outcome({ status: 'unreachable', path: new Int32Array(0), expanded: 5 })
    expect(Object.keys(valuesOf(none, 1, 'offline'))).toEqual(['Time to plan', 'Expanded'])
    const still = outcome({ expanded: 0 })
    expect(Object.keys(valuesOf(still, 1, 'offline'))).not.toContain('Expanded')
  })

  it.each([
    [0.04, 'less than 0.1 ms'],
    [0.1, '0.1 ms'],
    [9.94, '9.9 ms'],
    [9.96, '10 ms'],
    [999.4, '999 ms'],
    [999.6, '1.0 s'],
    [61_250, '61.3 s'],
  ])('write %d milliseconds as %s', (milliseconds, words) => {
    expect(timeInWords(milliseconds)).toBe(words)
  })
})
