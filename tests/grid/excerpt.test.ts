import { expect, test } from 'vitest'
import { describe as described, excerpt } from '../../src/grid/excerpt'

test.each([
  ['short', 'short', '"short"'],
  ['as long as it may be', 'x'.repeat(30), `"${'x'.repeat(30)}"`],
  ['longer', 'x'.repeat(31), `"${'x'.repeat(30)}…"`],
  ['with what cannot be printed', 'a\tb\u0000c\u200b', '"a·b·c·"'],
  ['of signs of two units', '🙂'.repeat(31), `"${'🙂'.repeat(30)}…"`],
])('a text that is %s is quoted', (_, text, quoted) => {
  expect(excerpt(text)).toBe(quoted)
})

test('a single sign is quoted without what comes after it', () => {
  expect(excerpt('xyz', 1)).toBe('"x"')
})

test.each([
  ['text', '"text"'],
  [3, '3'],
  [true, 'true'],
  [null, 'null'],
  [undefined, 'undefined'],
  [{ a: 1 }, 'an object'],
  [[], '[]'],
  [[1, 'a', false], '[1, "a", false]'],
  [[1, 2, 3, 4], 'a list of 4'],
  [[1, [2]], 'a list of 2'],
])('the value %j is described as %s', (value, words) => {
  expect(described(value)).toBe(words)
})
