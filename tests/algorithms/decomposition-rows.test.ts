import { expect, test } from 'vitest'
import { EVENT, plan, Tape } from '../../src/index'

/** The number of free cells that each row's event tells. */
function toldRows(width: number, walls: Uint8Array): number[] {
  const tape = new Tape()
  const grid = { width, height: walls.length / width, walls }
  plan({ grid, start: 0, goal: 0, diagonal: 'only-when-no-obstacles' }, 'decomposition', { tape })
  const events = Array.from({ length: tape.length }, (_, i) => i)
  return events.filter((i) => tape.kind(i) === EVENT.row).map((i) => tape.other(i))
}

test.each([2, 3, 5, 8, 13, 251, 253, 1021, 2048])('rows of %i cells are counted', (width) => {
  const height = 9
  // Row by row more obstacles, up to nothing else; none upon the start.
  const walls = Uint8Array.from({ length: width * height }, (_, cell) =>
    cell > 0 && cell % 8 < Math.floor(cell / width) ? 1 : 0,
  )
  const expected = Array.from({ length: height }, (_, y) =>
    walls.subarray(y * width, (y + 1) * width).reduce((free, wall) => free + 1 - wall, 0),
  )
  expect(expected.at(-1)).toBe(0)
  expect(toldRows(width, walls)).toEqual(expected)
  // Walls that lie anywhere in their buffer.
  for (const offset of [1, 2, 3]) {
    const moved = new Uint8Array(walls.length + offset).subarray(offset)
    moved.set(walls)
    expect(toldRows(width, moved)).toEqual(expected)
  }
})
