import fc from 'fast-check'
import { expect, test } from 'vitest'
import { InOrder } from '../../src/experiments/in-order'
import { rangeOfShard, readShard } from '../../src/experiments/shards'
import { durationInWords, timeLeft } from '../../src/experiments/time-left'

test('whatever the order in which they come, numbers are handed on in theirs', () => {
  const shuffled = fc.integer({ min: 1, max: 40 }).chain((n) =>
    fc.shuffledSubarray(
      Array.from({ length: n }, (_, i) => i + 3),
      { minLength: n },
    ),
  )
  fc.assert(
    fc.property(shuffled, (numbers) => {
      const handed: string[] = []
      const order = new InOrder<string>(3, (item) => handed.push(item))
      for (const number of numbers) {
        order.add(number, `item ${number}`)
        expect(order.next).toBe(3 + handed.length)
      }
      expect(handed).toEqual(numbers.toSorted((a, b) => a - b).map((n) => `item ${n}`))
    }),
  )
})

test('shards follow one another, have all maps once, and are alike in size', () => {
  fc.assert(
    fc.property(fc.integer({ min: 1, max: 50 }), fc.nat(1000), (of, maps) => {
      let next = 0
      for (let index = 1; index <= of; index++) {
        const { first, end } = rangeOfShard({ index, of }, maps)
        expect(first).toBe(next)
        expect(Math.abs(end - first - maps / of)).toBeLessThan(1)
        next = end
      }
      expect(next).toBe(maps)
    }),
  )
})

test('a shard is written as i/n', () => {
  expect(readShard('2/4')).toEqual({ index: 2, of: 4 })
  for (const text of ['', '0/4', '5/4', '2', '2/', '-1/4', '1/4/', 'a/b', '1.5/2']) {
    expect(() => readShard(text)).toThrow('A shard is written as 2/4')
  }
})

test('the time left is that of the pace since the clock started', () => {
  expect(timeLeft(0, 100, 500)).toBeNull()
  expect(timeLeft(50, 50, 500, 50)).toBeNull()
  expect(timeLeft(25, 100, 500)).toBe(1500)
  expect(timeLeft(60, 100, 500, 50)).toBe(2000)
})

test.each([
  [0, '0 s'],
  [1, '1 s'],
  [59_000, '59 s'],
  [59_001, '1 min 0 s'],
  [200_000, '3 min 20 s'],
  [3_599_500, '1 h 0 min'],
  [7_500_000, '2 h 5 min'],
])('%d ms are %s', (milliseconds, words) => {
  expect(durationInWords(milliseconds)).toBe(words)
})
