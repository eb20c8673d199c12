import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { packWalls, unpackWalls } from '../../../src/grid/formats/packed'
import { InputError } from '../../../src/index'

describe('walls', () => {
  test('take one bit a cell, the first in the lowest', () => {
    expect(packWalls(Uint8Array.of(1, 0, 1, 0, 0, 0, 0, 0, 1))).toEqual(Uint8Array.of(5, 1))
  })

  test('are unpacked as they were packed', () => {
    fc.assert(
      fc.property(fc.uint8Array({ max: 1, maxLength: 100 }), (walls) => {
        const bits = packWalls(walls)
        expect(bits.length).toBe(Math.ceil(walls.length / 8))
        expect(unpackWalls(bits, walls.length)).toEqual(walls)
      }),
    )
  })

  test.each([0, 8, 17, 4e9, Number.NaN])('two bytes are not the walls of %d cells', (count) => {
    expect(() => unpackWalls(new Uint8Array(2), count)).toThrow(InputError)
  })
})
