import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, expect, test, vi } from 'vitest'
import { linesOf } from '../../src/cli/lines'

const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
afterAll(() => rmSync(folder, { recursive: true }))

const path = join(folder, 'lines.txt')

test('lines are told with where they end, the last one also if it is not whole', () => {
  writeFileSync(path, 'aé\n\nb\r\nc')
  expect([...linesOf(path)]).toEqual([
    { text: 'aé', end: 4, isWhole: true },
    { text: '', end: 5, isWhole: true },
    { text: 'b\r', end: 8, isWhole: true },
    { text: 'c', end: 9, isWhole: false },
  ])
  writeFileSync(path, '')
  expect([...linesOf(path)]).toEqual([])
})

test('a file of many pieces is put together again, letters of several bytes too', () => {
  // Of lengths that have nothing to do with that of the pieces.
  const texts = Array.from({ length: 4000 }, (_, i) => `${i}${'é€🙂'.repeat(i % 97)}`)
  texts[2000] = '€'.repeat(1_500_000)
  writeFileSync(path, `${texts.join('\n')}\n`)
  const lines = [...linesOf(path)]
  expect(lines.map(({ text }) => text)).toEqual(texts)
  const bytes = texts.reduce((sum, text) => sum + Buffer.byteLength(text) + 1, 0)
  expect(lines.at(-1)?.end).toBe(bytes)
})

test('the pieces of a long line are copied once, however many there are', () => {
  const bytes = 30 * 2 ** 20
  writeFileSync(path, Buffer.alloc(bytes, 'a'))
  const concat = vi.spyOn(Buffer, 'concat')
  const [{ text }] = linesOf(path)
  const copied = concat.mock.results.reduce((sum, { value }) => sum + value.length, 0)
  concat.mockRestore()
  expect(text.length).toBe(bytes)
  expect(copied).toBeLessThanOrEqual(2 * bytes)
})
