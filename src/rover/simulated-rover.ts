import { type Direction, opposite, stepOffsets, stepped } from '../grid/directions'
import { type Cell, type Grid, isInside, isObstacle, type Point, pointOf } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { type DiagonalRule, type Directions, legalSteps } from '../grid/steps'
import { KNOWN } from '../trace/cell-state'
import { EVENT } from '../trace/events'
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
  stepsAtNews = 0
  readonly #grid: Grid
  readonly #diagonal: DiagonalRule
  readonly #lineOfSight: boolean
  readonly #tape: Tape | undefined
  /** The map as known, with a rim for what is sensed beyond the border. */
  readonly #known: Uint8Array
  /** For each place of it the directions of neighbours sensed as obstacles, and of those sensed as free. */
  readonly #obstacles: Uint8Array
  readonly #free: Uint8Array
  readonly #rim: number
  readonly #stride: number
  readonly #offsets: Int32Array
  readonly #trail: Cell[]
  #position: Point
  /** The middle of a square that is known in full. */
  #sensedFrom: Point | undefined

  constructor(problem: Problem, sensor: SensorSettings, tape?: Tape) {
    const { grid, start, goal, diagonal } = problem
    this.#grid = grid
    this.#diagonal = diagonal
    this.#lineOfSight = sensor.lineOfSight
    this.#tape = tape
    this.range = sensor.range
    this.#rim = sensor.range + 1
    this.#stride = grid.width + 2 * this.#rim
    this.#offsets = stepOffsets(this.#stride)
    const places = this.#stride * (grid.height + 2 * this.#rim)
    this.#known = new Uint8Array(places)
    this.#obstacles = new Uint8Array(places)
    this.#free = new Uint8Array(places)
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
    const { range } = this
    const { x, y } = this.#position
    const before = this.#sensedFrom
    for (let row = y - range; row <= y + range; row++) {
      const wasSensed = before !== undefined && Math.abs(row - before.y) <= range
      for (let column = x - range; column <= x + range; column++) {
        // Over the part of the row that lies in the square before.
        if (wasSensed && Math.abs(column - before.x) <= range) column = before.x + range
        else this.#senseCell(column, row)
      }
    }
    if (!this.#lineOfSight) this.#sensedFrom = this.#position
  }

  known(x: number, y: number): Knowledge {
    const place = this.#place(x, y)
    return place < 0 ? 'unknown' : KNOWLEDGE[this.#known[place]]
  }

  obstaclesAround({ x, y }: Point = this.#position): Directions {
    const place = this.#place(x, y)
    return place < 0 ? 0 : this.#obstacles[place]
  }

  legalSteps({ x, y }: Point = this.#position): Directions {
    const place = this.#place(x, y)
    return place < 0 ? 0 : legalSteps(this.#diagonal, ~this.#free[place] & 255)
  }

  refusedSteps(place: Point): Directions {
    return ~legalSteps(this.#diagonal, this.obstaclesAround(place)) & 255
  }

  step(direction: Direction): boolean {
    if (((this.legalSteps() >> direction) & 1) === 0) return false
    const from = this.#position
    this.#position = stepped(from, direction)
    const cell = this.#cell(this.#position)
    this.#trail.push(cell)
    this.#tape?.write(EVENT.step, cell, this.#cell(from))
    return true
  }

  #cell({ x, y }: Point): Cell {
    return y * this.#grid.width + x
  }

  /** Where (x, y) is in `#known`; -1 if it is farther out than any sensor reaches. */
  #place(x: number, y: number): number {
    const column = x + this.#rim
    const row = y + this.#rim
    const place = row * this.#stride + column
    const inside = column >= 0 && column < this.#stride && row >= 0 && place < this.#known.length
    return inside ? place : -1
  }

  #senseCell(x: number, y: number): void {
    const place = this.#place(x, y)
    if (this.#known[place] !== KNOWN.unknown) return
    if (this.#lineOfSight && !isInSight(this.#grid, this.#position, { x, y })) return
    const obstacle = isObstacle(this.#grid, x, y)
    this.stepsAtNews = this.steps
    this.#known[place] = obstacle ? KNOWN.obstacle : KNOWN.free
    const neighbours = obstacle ? this.#obstacles : this.#free
    for (let d = 0; d < 8; d++) neighbours[place + this.#offsets[d]] |= 1 << opposite(d)
    if (!isInside(this.#grid, x, y)) return
    this.sensed++
    this.#tape?.write(EVENT.sense, this.#cell({ x, y }), obstacle ? 1 : 0)
  }
}
