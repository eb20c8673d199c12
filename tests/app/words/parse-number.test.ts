import { expect, it } from 'vitest'
import { boundsInWords, parseNumber } from '../../../src/app/words/parse-number'

const whole = { kind: 'integer', min: 1, max: 50 } as const
const any = { kind: 'number', min: 0, max: 1e6 } as const

it.each([
  ['7', whole, { kind: 'number', value: 7 }],
  [' 50 ', whole, { kind: 'number', value: 50 }],
  ['2.5', any, { kind: 'number', value: 2.5 }],
  ['1e3', any, { kind: 'number', value: 1000 }],
  ['', whole, { kind: 'empty' }],
  ['   ', any, { kind: 'empty' }],
  ['0', whole, { kind: 'fault', text: '0 is not from 1 to 50.' }],
  ['51', whole, { kind: 'fault', text: '51 is not from 1 to 50.' }],
  ['2.5', whole, { kind: 'fault', text: '2.5 is not a whole number.' }],
  ['-0.1', any, { kind: 'fault', text: '-0.1 is not from 0 to 1000000.' }],
  ['seven', whole, { kind: 'fault', text: 'Enter a whole number from 1 to 50.' }],
] as const)('"%s" is read', (text, rule, parsed) => {
  expect(parseNumber(text, rule)).toEqual(parsed)
})

it('1e999 is no number', () => {
  expect(parseNumber('1e999', any).kind).toBe('fault')
})

it('what has to be entered is said', () => {
  expect(boundsInWords(whole)).toBe('Enter a whole number from 1 to 50.')
  expect(boundsInWords(any)).toBe('Enter a number from 0 to 1000000.')
})
