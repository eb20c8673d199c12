import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, expect, test } from 'vitest'
import { openRowsFile } from '../../src/cli/results-file'
import { rowToLine } from '../../src/experiments/results-json'
import { runMap } from '../../src/index'
import { settingsWith } from '../experiments/settings'

const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
afterAll(() => rmSync(folder, { recursive: true }))

const origin = { settings: settingsWith({ mapsPerCombination: 1 }), shard: { index: 2, of: 2 } }
// The second half of ten maps.
const mapLines = [5, 6, 7, 8, 9].map((map) =>
  runMap(origin.settings, map)
    .map((row) => `${rowToLine(row)}\n`)
    .join(''),
)

test('a file cut off after any byte is gone on with, and becomes the same', () => {
  const path = join(folder, 'rows.jsonl')
  const goOn = () => {
    const file = openRowsFile(path, origin)
    const { next } = file
    for (let map = next; map < 10; map++) file.write(mapLines[map - 5])
    file.close()
    return next
  }
  expect(goOn()).toBe(5)
  const whole = readFileSync(path)
  expect(goOn()).toBe(10)
  const header = whole.indexOf('\n') + 1
  expect(whole.subarray(header).toString()).toBe(mapLines.join(''))
  // One of them within a letter of several bytes.
  const inLetter = whole.indexOf('–') + 1
  expect(inLetter).toBeGreaterThan(1)
  const places = new Set([0, 1, inLetter, header - 1, header, header + 1, whole.length - 1])
  for (let place = 0; place < whole.length; place += 97) places.add(place)
  for (const place of places) {
    writeFileSync(path, whole.subarray(0, place))
    let complete = 5
    for (let end = header; complete < 10; complete++) {
      end += Buffer.byteLength(mapLines[complete - 5])
      if (end > place) break
    }
    expect(goOn()).toBe(complete)
    expect(readFileSync(path).equals(whole), `cut at ${place}`).toBe(true)
  }
})
