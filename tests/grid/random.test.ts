import fc from 'fast-check'
import { expect, test } from 'vitest'
import { randomInteger, randomNumbers } from '../../src/grid/random'

const take = (seed: number, count: number): number[] => {
  const random = randomNumbers(seed)
  return Array.from({ length: count }, random)
}

/** The same generator in exact arithmetic, where no machine can differ. */
function exactly(seed: number, count: number): number[] {
  const word = (n: bigint) => BigInt.asUintN(32, n)
  let state = word(BigInt(seed))
  return Array.from({ length: count }, () => {
    state = word(state + 0x9e3779b9n)
    let z = state
    z = word((z ^ (z >> 16n)) * 0x21f0aaadn)
    z = word((z ^ (z >> 15n)) * 0x735a2d97n)
    return Number(z ^ (z >> 15n)) / 2 ** 32
  })
}

test('the numbers of a seed are the same on every machine', () => {
  fc.assert(
    fc.property(fc.maxSafeInteger(), (seed) => {
      expect(take(seed, 20)).toEqual(exactly(seed, 20))
    }),
  )
})

test('they lie from 0 up to 1 and fill the range evenly', () => {
  const tenths = new Array<number>(10).fill(0)
  for (const number of take(1, 100_000)) tenths[Math.floor(number * 10)]++
  expect(tenths.reduce((a, b) => a + b)).toBe(100_000)
  for (const count of tenths) expect(Math.abs(count - 10_000)).toBeLessThan(500)
})

test('a random integer is any of those below the bound', () => {
  const random = randomNumbers(7)
  const found = new Set(Array.from({ length: 200 }, () => randomInteger(random, 6)))
  expect([...found].sort()).toEqual([0, 1, 2, 3, 4, 5])
})
