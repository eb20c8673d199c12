import { expect, it } from 'vitest'
import { inThousands } from '../../src/grid/thousands'

it.each([
  ['0', '0'],
  ['999', '999'],
  ['1000', '1,000'],
  ['-1234567.5', '-1,234,567.5'],
  ['-100', '-100'],
  ['0.0001', '0.0001'],
  ['1234.56789', '1,234.56789'],
  ['1e-7', '1e-7'],
])('%s has its thousands set apart, and no others of its digits', (digits, words) => {
  expect(inThousands(digits)).toBe(words)
})
