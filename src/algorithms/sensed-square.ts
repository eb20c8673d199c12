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

export function wayOver({ position, goal }: Pick<Rover, 'position' | 'goal'>, place: Point): Way {
  return {
    place,
    steps: distance(position, place) + distance(place, goal),
    length: euclideanDistance(position, place) + euclideanDistance(place, goal),
  }
}

/** Lengths are sums of two roots: what they differ by in less than this is rounding. */
const ROUNDING = 1e-9

/** The shorter of two ways; the first of equal ones. */
export function shorter(a: Way, b: Way): Way {
  if (a.steps !== b.steps) return b.steps < a.steps ? b : a
  return b.length < a.length - ROUNDING ? b : a
}

/** How many steps of the simplest path to a place are legal by what was sensed, `most` at most. */
export function freeSteps(rover: Rover, to: Point, most = Number.POSITIVE_INFINITY): number {
  let place = rover.position
  for (let steps = 0; steps < most && !isSamePlace(place, to); steps++) {
    const direction = simplestStep(place, to)
    if (!isIn(rover.legalSteps(place), direction)) return steps
    place = stepped(place, direction)
  }
  return Math.min(most, distance(rover.position, to))
}

/** Called with place after place. It is the same object each time: who keeps it makes a copy. */
export type Visit = (place: Point) => void

/**
 * What lies in the square that the rover senses. Made once for a drive: it has memory of its own, so
 * that nothing is allocated at each step.
 */
export class SensedSquare {
  readonly #rover: Rover
  /** Cells on a side, and for each cell of the square whether the flood was there. */
  readonly #side: number
  readonly #seen: Uint8Array
  /** Cells of the square that the flood has come to, by their index in it. */
  readonly #flooded: Int32Array

  constructor(rover: Rover) {
    this.#rover = rover
    this.#side = 2 * rover.range + 1
    this.#seen = new Uint8Array(this.#side ** 2)
    this.#flooded = new Int32Array(this.#side ** 2)
  }

  /** The places that a free simplest path leads to: on rays that bend once. */
  placesInReach(visit: Visit): void {
    const { x, y } = this.#rover.position
    const bend = { x, y }
    const place = { x, y }
    for (let first = 0; first < 8; first++) {
      bend.x = x
      bend.y = y
      while (this.#goOn(bend, first)) {
        visit(bend)
        if (!isDiagonal(first)) continue
        for (let turn = -1; turn <= 1; turn += 2) {
          const second = (first + turn) & 7
          place.x = bend.x
          place.y = bend.y
          while (this.#goOn(place, second)) visit(place)
        }
      }
    }
  }

  /** Moves a place by a step if that is free and stays in the square, and says whether it did. */
  #goOn(place: { x: number; y: number }, direction: Direction): boolean {
    const { position, range } = this.#rover
    if (!isIn(this.#rover.legalSteps(place), direction)) return false
    const x = place.x + DX[direction]
    const y = place.y + DY[direction]
    if (Math.abs(x - position.x) > range || Math.abs(y - position.y) > range) return false
    place.x = x
    place.y = y
    return true
  }

  /** The sensed part of an obstacle: the obstacle cells that hang together with `seed`. */
  obstacle(seed: Point, visit: Visit): void {
    const { position, range } = this.#rover
    const side = this.#side
    const left = position.x - range
    const top = position.y - range
    const place = { x: 0, y: 0 }
    let count = 0
    const flood = (column: number, row: number): void => {
      if (column < 0 || row < 0 || column >= side || row >= side) return
      const i = row * side + column
      if (this.#seen[i]) return
      this.#seen[i] = 1
      this.#flooded[count++] = i
    }
    flood(seed.x - left, seed.y - top)
    for (let i = 0; i < count; i++) {
      const column = this.#flooded[i] % side
      const row = (this.#flooded[i] - column) / side
      place.x = left + column
      place.y = top + row
      const obstacles = this.#rover.obstaclesAround(place)
      for (let d = 0; d < 8; d++) if (isIn(obstacles, d)) flood(column + DX[d], row + DY[d])
      visit(place)
    }
    for (let i = 0; i < count; i++) this.#seen[this.#flooded[i]] = 0
  }
}
