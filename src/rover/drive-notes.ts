import { type Direction, stepped } from '../grid/directions'
import type { Cell, Point } from '../grid/grid'
import { EVENT, LEAVES, type Leave } from '../trace/events'
import type { Tape } from '../trace/tape'
import type { Rover } from './rover'

/**
 * What an online planner notes on the tape, in the rover's own terms: places and directions. It
 * only writes, so it tells the planner nothing about the map. Without a tape it does nothing.
 */
export class DriveNotes {
  readonly #rover: Rover
  readonly #tape: Tape | undefined
  #hits = 0

  constructor(rover: Rover, tape?: Tape) {
    this.#rover = rover
    this.#tape = tape
  }

  /** The planner is at this line of its pseudocode; what the rover does now belongs to it. */
  at(line: number): this {
    this.#tape?.at(line)
    return this
  }

  /** An obstacle in this direction stopped the rover: a hit point. */
  hit(obstacle: Direction): void {
    this.#hits++
    const cell = this.#cell(stepped(this.#rover.position, obstacle))
    this.#tape?.write(EVENT.hit, this.#here(), cell, this.#hits)
  }

  /** The rover came round the obstacle once, in so many steps. */
  around(steps: number): void {
    this.#tape?.write(EVENT.around, this.#here(), -1, steps)
  }

  /** The rover is in the same state as after `step` steps, so it goes round for ever. */
  loop(step: number): void {
    this.#tape?.write(EVENT.loop, this.#here(), -1, step)
  }

  /** The local tangent graph is drawn up anew, with these nodes. */
  nodes(ways: readonly { readonly place: Point; readonly steps: number }[]): void {
    this.#tape?.write(EVENT.scan, this.#here())
    for (const { place, steps } of ways) {
      this.#tape?.write(EVENT.node, this.#cell(place), -1, steps)
    }
  }

  /** The rover leaves the boundary: the leave point that belongs to the latest hit point. */
  leave(why: Leave): void {
    this.#tape?.write(EVENT.leave, this.#here(), LEAVES.indexOf(why), this.#hits)
  }

  /** The obstacle cell in this direction is kept at the rover's side. */
  feel(obstacle: Direction): void {
    this.#tape?.write(EVENT.feel, this.#cell(stepped(this.#rover.position, obstacle)))
  }

  turn(turn: 'left' | 'right'): void {
    this.#tape?.write(EVENT.turn, this.#here(), turn === 'left' ? 0 : 1)
  }

  mLine(place: Point): void {
    this.#tape?.write(EVENT.mLine, this.#cell(place))
  }

  /** The rover heads for a place; `distance` from it over that place to the goal. */
  target(place: Point, distance: number): void {
    this.#tape?.write(EVENT.target, this.#cell(place), -1, distance)
  }

  /** The planner's variable of this number has a new value. */
  value(variable: number, value: number): void {
    this.#tape?.write(EVENT.value, this.#here(), variable, value)
  }

  #here(): Cell {
    return this.#cell(this.#rover.position)
  }

  #cell({ x, y }: Point): Cell {
    return this.#tape?.cellAt(x, y) ?? -1
  }
}
