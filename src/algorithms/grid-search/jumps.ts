import type { Direction } from '../../grid/directions'
import type { Cell } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { Diagonals } from './diagonals'
import { type Memory, OPEN } from './memory'

/** Looks from a cell along its ways for the next cell where a shortest path may turn. */
export class Jumps {
  /** Where the latest jump ended: the weight of the path, and the direction of its last step. */
  weight = 0
  direction: Direction = 0
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  readonly #offsets: Int32Array
  readonly #diagonalWeight: number
  readonly #goal: Cell
  readonly #memory: Memory
  readonly #diagonals: Diagonals

  constructor(
    legal: Uint8Array,
    successors: Uint8Array,
    offsets: Int32Array,
    diagonalWeight: number,
    problem: Problem,
    memory: Memory,
  ) {
    this.#legal = legal
    this.#successors = successors
    this.#offsets = offsets
    this.#diagonalWeight = diagonalWeight
    this.#goal = problem.goal
    this.#memory = memory
    this.#diagonals = new Diagonals(legal, successors, offsets, problem)
  }

  /**
   * The jump point to which a legal step from `from` leads; -1 if it leads to none, or not by a
   * shorter path than is known. A corner with one way on is no choice, so it is noted and passed.
   */
  from(from: Cell, direction: Direction, weight: number): Cell {
    const { states, weights } = this.#memory
    let cell = from
    let d = direction
    let length = weight
    for (;;) {
      const steps = d & 1 ? this.#diagonals.steps(cell, d) : this.#straight(cell, d)
      if (steps === 0) return -1
      length += steps * (d & 1 ? this.#diagonalWeight : 1)
      cell += steps * this.#offsets[d]
      const ways = this.#successors[(d << 8) | this.#legal[cell]]
      if (cell === this.#goal || (ways & (ways - 1)) !== 0) break
      if (states[cell] !== 0 && length >= weights[cell]) return -1
      states[cell] = OPEN | d
      weights[cell] = length
      d = 31 - Math.clz32(ways)
    }
    this.weight = length
    this.direction = d
    return cell
  }

  /** Steps to the first cell with another way than onward, or to the goal; 0 if the way ends before. */
  #straight(from: Cell, d: Direction): number {
    const legal = this.#legal
    const successors = this.#successors
    const goal = this.#goal
    const offset = this.#offsets[d]
    const row = d << 8
    const onward = 1 << d
    let cell = from
    let steps = 0
    let ways = onward
    while (ways === onward) {
      cell += offset
      steps++
      if (cell === goal) return steps
      ways = successors[row | legal[cell]]
    }
    return ways === 0 ? 0 : steps
  }
}
