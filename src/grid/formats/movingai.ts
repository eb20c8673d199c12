import { InputError } from '../errors'
import { excerpt } from '../excerpt'
import type { Grid } from '../grid'
import { checkSize } from '../problem'
import { rowByRow } from '../text-map'

/**
 * The map in the format of the MovingAI benchmarks, `.` free and `@` obstacle, in parts. Start, goal
 * and the diagonal rule have no place in it.
 * Source: N. R. Sturtevant, "Benchmarks for grid-based pathfinding", 2012.
 */
export function* movingAiMap(grid: Grid): Generator<string, void, void> {
  yield `type octile\nheight ${grid.height}\nwidth ${grid.width}\nmap\n`
  for (const row of rowByRow(grid, '@')) yield `${row}\n`
}

/** The signs of cells that can be passed: ground, ground of another kind, swamp. */
const [GROUND, OTHER_GROUND, SWAMP] = Array.from('.GS', (sign) => sign.charCodeAt(0))

/**
 * The map in a MovingAI file: `.`, `G` and `S` are free, every other sign is an obstacle.
 * @throws InputError that names the line of the header or the row of the map that is wrong.
 */
export function readMovingAiMap(text: string): Grid {
  // Only the header is split into lines: a file may have many more lines than a map has rows.
  const header = /^(.*)\r?\n(.*)\r?\n(.*)\r?\n(.*)(?:\r?\n|$)/.exec(text)
  if (!header) {
    throw new InputError(
      'The map ends in its header: expected the lines "type octile", "height", "width" and "map".',
    )
  }
  mustBe(header[1], 1, 'type octile')
  const height = sizeIn(header[2], 2, 'height')
  const width = sizeIn(header[3], 3, 'width')
  mustBe(header[4], 4, 'map')
  checkSize(width, height)
  return readRows(text, header[0].length, width, height)
}

function mustBe(line: string, number: number, expected: string): void {
  if (line.trimEnd() === expected) return
  throw new InputError(`Line ${number} must be "${expected}", but is ${excerpt(line)}.`)
}

function sizeIn(line: string, number: number, side: string): number {
  const match = /^(\w+) +(\d+)\s*$/.exec(line)
  if (match?.[1] === side) return Number(match[2])
  throw new InputError(
    `Line ${number} must be "${side}" and a whole number, but is ${excerpt(line)}.`,
  )
}

function readRows(text: string, from: number, width: number, height: number): Grid {
  const walls = new Uint8Array(width * height)
  let at = from
  for (let y = 0; y < height; y++) {
    if (at >= text.length) {
      throw new InputError(`The map ends after row ${y}, but its height is ${height}.`)
    }
    const end = endOfLine(text, at)
    const length = text[end - 1] === '\r' && end > at ? end - 1 - at : end - at
    if (length !== width) {
      const fault = length < width ? `ends after column ${length}` : `has ${length} columns`
      throw new InputError(`Row ${y + 1} of the map ${fault}, but its width is ${width}.`)
    }
    for (let x = 0; x < width; x++) {
      const sign = text.charCodeAt(at + x)
      if (sign !== GROUND && sign !== OTHER_GROUND && sign !== SWAMP) walls[y * width + x] = 1
    }
    at = end + 1
  }
  const rest = text.slice(at).trim()
  if (rest !== '') {
    throw new InputError(
      `After row ${height}, the map's height, the file goes on: ${excerpt(rest)}.`,
    )
  }
  return { width, height, walls }
}

function endOfLine(text: string, from: number): number {
  const end = text.indexOf('\n', from)
  return end < 0 ? text.length : end
}
