import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { rowByRow } from '../../../src/grid/text-map'
import type { Problem } from '../../../src/index'
import { byId, make, pieces, seeds, sizes } from './maps'

const smallest = fc.integer({ min: 2, max: 6 })

interface Room {
  left: number
  top: number
  width: number
  height: number
}

/**
 * The rooms of a map, found without knowing how it was made: with its doors shut, each piece of
 * free cells. A door is a free cell with obstacles at two opposite sides and free cells at the others.
 */
function roomsOf({ grid: { width, height, walls } }: Problem): { rooms: Room[]; doors: number } {
  const wall = (x: number, y: number) =>
    x < 0 || y < 0 || x >= width || y >= height || walls[y * width + x] === 1
  const taken = Uint8Array.from(walls)
  let doors = 0
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (wall(x, y)) continue
      const upright = wall(x, y - 1) && wall(x, y + 1) && !wall(x - 1, y) && !wall(x + 1, y)
      const lying = wall(x - 1, y) && wall(x + 1, y) && !wall(x, y - 1) && !wall(x, y + 1)
      if (!upright && !lying) continue
      taken[y * width + x] = 1
      doors++
    }
  }
  const rooms: Room[] = []
  for (let first = 0; first < taken.length; first++) {
    if (taken[first]) continue
    const cells = [first]
    taken[first] = 1
    for (const cell of cells) {
      const x = cell % width
      for (const next of [
        x > 0 ? cell - 1 : -1,
        x < width - 1 ? cell + 1 : -1,
        cell - width,
        cell + width,
      ]) {
        if (next < 0 || next >= taken.length || taken[next]) continue
        taken[next] = 1
        cells.push(next)
      }
    }
    const xs = cells.map((cell) => cell % width)
    const ys = cells.map((cell) => Math.floor(cell / width))
    const room = { left: Math.min(...xs), top: Math.min(...ys), width: 0, height: 0 }
    room.width = Math.max(...xs) - room.left + 1
    room.height = Math.max(...ys) - room.top + 1
    expect(cells.length, 'a room is a rectangle').toBe(room.width * room.height)
    rooms.push(room)
  }
  return { rooms, doors }
}

test('all rooms are joined', () => {
  fc.assert(
    fc.property(sizes, smallest, seeds, (size, room, seed) => {
      expect(pieces(make('rooms', size, { room }, seed))).toBe(1)
    }),
    { numRuns: 500 },
  )
})

describe('every room', () => {
  test('is a rectangle not smaller than asked for, with one door fewer than rooms', () => {
    fc.assert(
      fc.property(sizes, smallest, seeds, (size, room, seed) => {
        fc.pre(Math.min(size.width, size.height) >= room)
        const { rooms, doors } = roomsOf(make('rooms', size, { room }, seed))
        expect(doors).toBe(rooms.length - 1)
        for (const { width, height } of rooms) {
          expect(Math.min(width, height)).toBeGreaterThanOrEqual(room)
        }
      }),
      { numRuns: 500 },
    )
  })

  test('is divided as long as it can be, but for walls that would end before a door', () => {
    const { rooms } = roomsOf(make('rooms', { width: 200, height: 200 }, { room: 5 }, 1))
    const large = rooms.filter(({ width, height }) => Math.max(width, height) > 2 * 5)
    expect(rooms.length).toBeGreaterThan(400)
    expect(large.length).toBeLessThan(rooms.length / 5)
  })
})

test('the longer side is divided first', () => {
  for (let seed = 0; seed < 50; seed++) {
    const rows = [...rowByRow(make('rooms', { width: 60, height: 20 }, { room: 9 }, seed).grid)]
    for (const row of rows) expect(row.replaceAll('.', '').length).toBeLessThan(59)
    expect(rows.filter((row) => row.includes('#')).length).toBeGreaterThanOrEqual(19)
  }
})

test('a map too small to divide stays one room', () => {
  const [{ default: usual }] = byId('rooms').params
  const side = 2 * usual
  expect([...rowByRow(make('rooms', { width: side, height: side }, {}, 1).grid)]).toEqual(
    new Array(side).fill('.'.repeat(side)),
  )
  const walls = make('rooms', { width: side + 1, height: side }, {}, 1).grid.walls
  expect(walls.filter((wall) => wall).length).toBe(side - 1)
})
