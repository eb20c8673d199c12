import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { movingAiMap, readMovingAiMap } from '../../../src/grid/formats/movingai'
import { openMap } from '../../../src/grid/formats/open-map'
import { grids } from '../arbitraries'
import { mustRefuse, whole } from './files'

/** A MovingAI map of these rows, with some lines of its header changed. */
function map(rows: readonly string[], header: Record<number, string> = {}): string {
  const lines = ['type octile', `height ${rows.length}`, `width ${rows[0].length}`, 'map', ...rows]
  return `${lines.map((line, i) => header[i + 1] ?? line).join('\n')}\n`
}

test('a map is written as the benchmarks have it', () => {
  const grid = { width: 3, height: 2, walls: Uint8Array.of(0, 1, 0, 1, 1, 0) }
  expect(whole(movingAiMap(grid))).toBe('type octile\nheight 2\nwidth 3\nmap\n.@.\n@@.\n')
})

test('a map that was written is read back', () => {
  fc.assert(
    fc.property(grids, (grid) => {
      const text = whole(movingAiMap(grid))
      expect(readMovingAiMap(text)).toEqual(grid)
      expect(readMovingAiMap(text.replaceAll('\n', '\r\n'))).toEqual(grid)
      expect(readMovingAiMap(text.trimEnd())).toEqual(grid)
    }),
  )
})

test('".", "G" and "S" are free, all else is an obstacle', () => {
  const grid = readMovingAiMap(map(['.GS@O', 'TW#s ', 'g,-xé']))
  expect([...grid.walls]).toEqual([0, 0, 0, ...Array(12).fill(1)])
})

describe('opening', () => {
  test('start and goal are put left and right, and steps past a corner are not allowed', () => {
    const text = map(['T...T', '..T..', 'TTT.T'])
    const opened = openMap(`\uFEFF\n${text}`)
    expect(opened).toEqual({
      problem: {
        grid: readMovingAiMap(text),
        start: 5,
        goal: 9,
        diagonal: 'only-when-no-obstacles',
      },
      notes: ['The file has no start or goal: they were put at (0, 1) and (4, 1).'],
    })
  })

  test.each([
    [
      'no octile map',
      map(['..', '..'], { 1: 'type hex' }),
      'Line 1 must be "type octile", but is "type hex".',
    ],
    [
      'no height',
      map(['..', '..'], { 2: 'width 2' }),
      'Line 2 must be "height" and a whole number, but is "width 2".',
    ],
    ['a broken height', map(['..', '..'], { 2: 'height 2.5' }), 'but is "height 2.5".'],
    [
      'a width without number',
      map(['..', '..'], { 3: 'width' }),
      'Line 3 must be "width" and a whole number, but is "width".',
    ],
    ['no "map"', map(['..', '..'], { 4: '..' }), 'Line 4 must be "map", but is "..".'],
    ['nothing but the type', 'type octile', 'The map ends in its header'],
    ['half a header', 'type octile\nheight 2\nwidth 2', 'The map ends in its header'],
    ['a map that is too small', map(['.']), "The map's width is 1"],
    ['a map that is too wide', map(['..', '..'], { 3: 'width 2049' }), "The map's width is 2049"],
    [
      'a map that is too high',
      map(['..', '..'], { 2: 'height 99999999999' }),
      "The map's height is 99999999999",
    ],
    [
      'no rows',
      'type octile\nheight 2\nwidth 2\nmap',
      'The map ends after row 0, but its height is 2.',
    ],
    [
      'too few rows',
      map(['..', '..'], { 2: 'height 3' }),
      'The map ends after row 2, but its height is 3.',
    ],
    [
      'too many rows',
      map(['..', '..', '@@'], { 2: 'height 2' }),
      'After row 2, the map\'s height, the file goes on: "@@".',
    ],
    [
      'a short row',
      map(['...', '..', '...']),
      'Row 2 of the map ends after column 2, but its width is 3.',
    ],
    [
      'a long row',
      map(['...', '....', '...']),
      'Row 2 of the map has 4 columns, but its width is 3.',
    ],
    ['an empty row', map(['...', '', '...']), 'Row 2 of the map ends after column 0'],
    [
      'a map cut off in a row',
      map(['...', '...']).slice(0, -2),
      'Row 2 of the map ends after column 2',
    ],
    ['no free cell', map(['@@', 'TT']), 'The map has no free cell.'],
  ])('%s is refused', (_, text, message) => {
    mustRefuse(text, message)
  })
})
