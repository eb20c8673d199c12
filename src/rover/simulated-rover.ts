import { type Direction, DX, DY } from '../grid/directions'
import { type Cell, type Grid, isInside, isObstacle, type Point, pointOf } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { type DiagonalRule, type Directions, legalSteps } from '../grid/steps'
import { EVENT } from '../trace/events'
import { KNOWN } from '../trace/frame'
import type { Tape } from '../trace/tape'
import { isInSight } from './line-of-sight'
import type { Knowledge, Rover, SensorSettings } from './rover'

const KNOWLEDGE: readonly Knowledge[] = ['unknown', 'free', 'obstacle']

/**
 * A rover on a map that it senses square by square. It writes what it senses and where it goes on
 * the tape, and keeps its trail for whoever started it.
 */
export class SimulatedRover implements Rover {
  readonly goal: Point
  readonly range: number
  /** How many cells of the map it has sensed. */
  sensed = 0
  readonly #grid: Grid
  readonly #diagonal: DiagonalRule
  readonly #lineOfSight: boolean
  readonly #tape: Tape | undefined
  /** The map as known, with a rim of `range` cells for what is sensed beyond the border. */
  readonly #known: Uint8Array
  readonly #stride: number
  readonly #trail: Cell[]
  #position: Point

  constructor(problem: Problem, sensor: SensorSettings, tape?: Tape) {
    const { grid, start, goal, diagonal } = problem
    this.#grid = grid
    this.#diagonal = diagonal
    this.#lineOfSight = sensor.lineOfSight
    this.#tape = tape
    this.range = sensor.range
    this.#stride = grid.width + 2 * sensor.range
    this.#known = new Uint8Array(this.#stride * (grid.height + 2 * sensor.range))
    this.#position = pointOf(grid.width, start)
    this.goal = pointOf(grid.width, goal)
    this.#trail = [start]
    tape?.write(EVENT.step, start)
  }

  get position(): Point {
    return this.#position
  }

  get steps(): number {
    return this.#trail.length - 1
  }

  /** The cells walked, from the start to where the rover is. */
  trail(): Int32Array {
    return Int32Array.from(this.#trail)
  }

  sense(): void {
    const { x, y } = this.#position
    for (let dy = -this.range; dy <= this.range; dy++) {
      for (let dx = -this.range; dx <= this.range; dx++) this.#senseCell(x + dx, y + dy)
    }
  }

  known(x: number, y: number): Knowledge {
    const i = this.#index(x, y)
    return i < 0 ? 'unknown' : KNOWLEDGE[this.#known[i]]
  }

  obstaclesAround({ x, y }: Point = this.#position): Directions {
    let obstacles = 0
    for (let d = 0; d < 8; d++) {
      if (this.known(x + DX[d], y + DY[d]) === 'obstacle') obstacles |= 1 << d
    }
    return obstacles
  }

  legalSteps({ x, y }: Point = this.#position): Directions {
    let blocked = 0
    for (let d = 0; d < 8; d++) {
      if (this.known(x + DX[d], y + DY[d]) !== 'free') blocked |= 1 << d
    }
    return legalSteps(this.#diagonal, blocked)
  }

  step(direction: Direction): boolean {
    if (((this.legalSteps() >> direction) & 1) === 0) return false
    const from = this.#position
    this.#position = { x: from.x + DX[direction], y: from.y + DY[direction] }
    const cell = this.#cell(this.#position)
    this.#trail.push(cell)
    this.#tape?.write(EVENT.step, cell, this.#cell(from))
    return true
  }

  #cell({ x, y }: Point): Cell {
    return y * this.#grid.width + x
  }

  /** Where (x, y) is in `#known`; -1 if it is farther out than any sensor reaches. */
  #index(x: number, y: number): number {
    const column = x + this.range
    const row = y + this.range
    const inside = column >= 0 && column < this.#stride && row >= 0
    const i = row * this.#stride + column
    return inside && i < this.#known.length ? i : -1
  }

  #senseCell(x: number, y: number): void {
    const i = this.#index(x, y)
    if (this.#known[i] !== KNOWN.unknown) return
    if (this.#lineOfSight && !isInSight(this.#grid, this.#position, { x, y })) return
    const obstacle = isObstacle(this.#grid, x, y)
    this.#known[i] = obstacle ? KNOWN.obstacle : KNOWN.free
    if (!isInside(this.#grid, x, y)) return
    this.sensed++
    this.#tape?.write(EVENT.sense, this.#cell({ x, y }), obstacle ? 1 : 0)
  }
}
