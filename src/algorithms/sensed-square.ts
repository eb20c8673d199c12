import { type Direction, DX, DY, isDiagonal, stepped } from '../grid/directions'
import { isSamePlace, type Point } from '../grid/grid'
import { distance, euclideanDistance, simplestStep } from '../grid/simplest-path'
import type { Rover } from '../rover/rover'
import { isIn } from './boundary'

/** The way from the rover over a place to the goal, both parts as simplest paths. */
export interface Way {
  readonly place: Point
  readonly steps: number
  /** Euclidean length, to tell ways of equally many steps apart. */
  readonly length: number
}

export function wayOver({ position, goal }: Rover, place: Point): Way {
  return {
    place,
    steps: distance(position, place) + distance(place, goal),
    length: euclideanDistance(position, place) + euclideanDistance(place, goal),
  }
}

/** The shorter of two ways; the first of equal ones. */
export function shorter(a: Way, b: Way): Way {
  return b.steps < a.steps || (b.steps === a.steps && b.length < a.length) ? b : a
}

/** The places of the sensed square that a free simplest path leads to: on rays that bend once. */
export function* placesInReach(rover: Rover): Generator<Point> {
  for (let first = 0; first < 8; first++) {
    for (const bend of ray(rover, rover.position, first)) {
      yield bend
      if (!isDiagonal(first)) continue
      yield* ray(rover, bend, first - 1)
      yield* ray(rover, bend, (first + 1) & 7)
    }
  }
}

function* ray(rover: Rover, from: Point, direction: Direction): Generator<Point> {
  for (let place = from; isIn(rover.legalSteps(place), direction); ) {
    place = stepped(place, direction)
    if (distance(place, rover.position) > rover.range) return
    yield place
  }
}

/** How many steps of the simplest path to a place are legal by what was sensed, `most` at most. */
export function freeSteps(rover: Rover, to: Point, most = Number.POSITIVE_INFINITY): number {
  let place = rover.position
  for (let steps = 0; steps < most && !isSamePlace(place, to); steps++) {
    const direction = simplestStep(place, to)
    if (!isIn(rover.legalSteps(place), direction)) return steps
    place = stepped(place, direction)
  }
  return Math.min(
    most,
    Math.max(Math.abs(to.x - rover.position.x), Math.abs(to.y - rover.position.y)),
  )
}

/** The sensed part of an obstacle: the obstacle cells of the square that hang together with `seed`. */
export function sensedObstacle(rover: Rover, seed: Point): Point[] {
  const { position, range } = rover
  const side = 2 * range + 1
  const place = ({ x, y }: Point) => (y - position.y + range) * side + x - position.x + range
  const inSquare = ({ x, y }: Point) =>
    Math.abs(x - position.x) <= range && Math.abs(y - position.y) <= range
  const found = [seed]
  const seen = new Uint8Array(side * side)
  seen[place(seed)] = 1
  for (const cell of found) {
    for (let d = 0; d < 8; d++) {
      const next = { x: cell.x + DX[d], y: cell.y + DY[d] }
      if (!inSquare(next) || seen[place(next)] || rover.known(next.x, next.y) !== 'obstacle')
        continue
      seen[place(next)] = 1
      found.push(next)
    }
  }
  return found
}
