import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { fromBase64, toBase64 } from '../../../src/grid/formats/base64'
import { InputError } from '../../../src/index'

const bytes = fc.uint8Array({ maxLength: 100 })

describe('Base64', () => {
  test('is the usual one', () => {
    fc.assert(
      fc.property(bytes, (some) => {
        expect(toBase64(some)).toBe(Buffer.from(some).toString('base64'))
      }),
    )
  })

  test('is read as it was written, also where it is long', () => {
    fc.assert(
      fc.property(bytes, (some) => {
        expect(fromBase64(toBase64(some))).toEqual(some)
      }),
    )
    const long = Uint8Array.from({ length: 20_000 }, (_, i) => (i * 31) % 256)
    expect(toBase64(long)).toBe(Buffer.from(long).toString('base64'))
    expect(fromBase64(toBase64(long))).toEqual(long)
  })

  test('any other text is refused', () => {
    const signs = fc.constantFrom('A', 'B', 'z', '/', '=', '-', ' ', 'é', '\n')
    fc.assert(
      fc.property(fc.string({ unit: signs, maxLength: 12 }), (text) => {
        // Node reads more than it writes: a text is sound if it is what Node would write.
        const sound = Buffer.from(text, 'base64').toString('base64') === text
        if (sound) expect(toBase64(fromBase64(text))).toBe(text)
        else expect(() => fromBase64(text)).toThrow(InputError)
      }),
      { numRuns: 2000 },
    )
  })

  test.each([
    ['AAA', 'groups of 4 characters'],
    ['AA-A', 'Character 3 of the packed map is not Base64.'],
    ['AAé=', 'Character 3'],
    ['A===', 'Character 2'],
    ['AB==', 'cut off'],
  ])('%j: %s', (text, message) => {
    expect(() => fromBase64(text)).toThrow(message)
  })
})
