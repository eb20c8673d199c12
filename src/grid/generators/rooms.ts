import { randomInteger } from '../random'
import { generator } from './generator'

export const rooms = generator({
  id: 'rooms',
  title: 'Rooms',
  help: 'Rooms divided by walls again and again, with one door in each wall.',
  params: [
    {
      name: 'room',
      label: 'Smallest room',
      kind: 'integer',
      min: 2,
      max: 200,
      default: 5,
      unit: 'cells',
      help: 'Least number of cells on a side of a room.',
    },
  ],

  build({ width, height }, { room }, random) {
    const walls = new Uint8Array(width * height)
    const map: Plan = { size: [width, height], strides: [1, width], walls }
    divideAll(map, room, random)
    return { walls, start: 0, goal: walls.length - 1 }
  },
})

/** Axis 0 goes along x, axis 1 along y, so that the same code builds walls of both kinds. */
type Axis = 0 | 1
type Pair = readonly [number, number]

interface Plan {
  readonly size: Pair
  /** What is added to a cell's index by a step along each axis. */
  readonly strides: Pair
  readonly walls: Uint8Array
}

interface Room {
  /** Its top left cell. */
  readonly corner: Pair
  readonly size: Pair
}

/** Recursive division, written as a loop over the rooms that are still to be divided. */
function divideAll(map: Plan, smallest: number, random: () => number): void {
  const rooms: Room[] = [{ corner: [0, 0], size: map.size }]
  for (let room = rooms.pop(); room; room = rooms.pop()) {
    const [width, height] = room.size
    const longer = width > height || (width === height && random() < 0.5) ? 0 : 1
    for (const axis of longer === 0 ? ([0, 1] as const) : ([1, 0] as const)) {
      const place = wallPlace(map, room, axis, smallest, random)
      if (place < 0) continue
      buildWall(map, room, axis, place, random)
      rooms.push(part(room, axis, 0, place), part(room, axis, place + 1, room.size[axis]))
      break
    }
  }
}

/**
 * Where a wall may divide a room along `axis`, counted from its corner; -1 if nowhere. Both parts
 * must be large enough, and the wall must not end before a door.
 */
function wallPlace(
  { size, strides, walls }: Plan,
  room: Room,
  axis: Axis,
  smallest: number,
  random: () => number,
): number {
  const places = room.size[axis] - 2 * smallest
  if (places <= 0) return -1
  const other = axis === 0 ? 1 : 0
  const first = room.corner[0] * strides[0] + room.corner[1] * strides[1]
  const isDoor = (place: number, end: number) => {
    const outside = room.corner[other] + end < 0 || room.corner[other] + end >= size[other]
    return !outside && walls[first + place * strides[axis] + end * strides[other]] === 0
  }
  const begin = randomInteger(random, places)
  for (let i = 0; i < places; i++) {
    const place = smallest + ((begin + i) % places)
    if (!isDoor(place, -1) && !isDoor(place, room.size[other])) return place
  }
  return -1
}

function buildWall(
  { strides, walls }: Plan,
  { corner, size }: Room,
  axis: Axis,
  place: number,
  random: () => number,
): void {
  const other = axis === 0 ? 1 : 0
  const first = corner[0] * strides[0] + corner[1] * strides[1] + place * strides[axis]
  const door = randomInteger(random, size[other])
  for (let i = 0; i < size[other]; i++) if (i !== door) walls[first + i * strides[other]] = 1
}

/** The part of a room from `from` up to `to`, without it, along an axis. */
function part({ corner, size }: Room, axis: Axis, from: number, to: number): Room {
  return axis === 0
    ? { corner: [corner[0] + from, corner[1]], size: [to - from, size[1]] }
    : { corner: [corner[0], corner[1] + from], size: [size[0], to - from] }
}
