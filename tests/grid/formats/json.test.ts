import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { parseJson } from '../../../src/grid/formats/json'
import { InputError } from '../../../src/index'

function isJson(text: string): boolean {
  try {
    JSON.parse(text)
    return true
  } catch {
    return false
  }
}

test('all JSON is read as the engine reads it', () => {
  fc.assert(
    fc.property(fc.jsonValue(), fc.constantFrom(0, 2, '\t'), (value, indent) => {
      const text = JSON.stringify(value, null, indent)
      expect(parseJson(text)).toEqual(JSON.parse(text))
    }),
    { numRuns: 500 },
  )
})

test('what is refused is what the engine refuses', () => {
  const pieces = fc.constantFrom(
    ...['{', '}', '[', ']', ',', ':', '"', '"a"', '\\', '\\u00e9', '\\u12', '\\n', '\n', ' ', '\t'],
    ...[
      '0',
      '1',
      '-',
      '.5',
      'e',
      'E+1',
      '01',
      'true',
      'fals',
      'null',
      'NaN',
      'é',
      '\u0001',
      '\u00a0',
    ],
  )
  fc.assert(
    fc.property(fc.array(pieces, { maxLength: 8 }), (list) => {
      const text = list.join('')
      if (isJson(text)) expect(parseJson(text)).toEqual(JSON.parse(text))
      else expect(() => parseJson(text)).toThrow(InputError)
    }),
    { numRuns: 20_000 },
  )
})

test('a sound text that is damaged at one place', () => {
  const sound = '{"a": [1, -2.5e3, "x\\u00e9\\n"], "b": {"c": null}, "d": true}'
  for (let at = 0; at < sound.length; at++) {
    for (const put of ['', '"', '}', ']', ',', ':', 'x', '\n']) {
      const text = sound.slice(0, at) + put + sound.slice(at + 1)
      if (isJson(text)) expect(parseJson(text)).toEqual(JSON.parse(text))
      else expect(() => parseJson(text), text).toThrow(InputError)
    }
    expect(() => parseJson(sound.slice(0, at)), 'cut off').toThrow(InputError)
  }
})

describe('the message has the line, the column and what was expected', () => {
  test.each([
    ['{"a" 1}', 'line 1, column 6: expected ":", but found "1}".'],
    ['{\n  "a": [1,\n  2 3]\n}', 'line 3, column 5: expected "," or "]", but found "3]·}".'],
    ['{"a": 1,\r\n}', 'line 2, column 1: expected a key in double quotes, but found "}".'],
    ['{"a": 1', 'line 1, column 8: expected "," or "}", but it ends.'],
    ['{"a": "bc', 'line 1, column 10: expected the rest of a text in double quotes, but it ends.'],
    ['{"a": }', 'line 1, column 7: expected a value, but found "}".'],
    ['[', 'line 1, column 2: expected a value or "]", but it ends.'],
    [
      "{'a': 1}",
      'line 1, column 2: expected a key in double quotes or "}", but found "\'a\': 1}".',
    ],
    ['{} {}', 'line 1, column 4: expected nothing more, but found "{}".'],
    ['{"a": NaN}', 'line 1, column 7: expected a value, but found "NaN}".'],
    ['', 'line 1, column 1: expected a value, but it ends.'],
  ])('%j', (text, message) => {
    expect(() => parseJson(text)).toThrow(`The file is broken in ${message}`)
  })
})

test('brackets without end and numbers without end are refused', () => {
  expect(() => parseJson('['.repeat(1_000_000))).toThrow('expected at most 100 levels')
  expect(() => parseJson(`${'{"a":'.repeat(1_000_000)}1`)).toThrow('expected at most 100 levels')
  expect(() => parseJson(`[${'1'.repeat(1_000_000)}]`)).toThrow(InputError)
  expect(parseJson(`${'['.repeat(100)}${']'.repeat(100)}`)).toBeInstanceOf(Array)
})
