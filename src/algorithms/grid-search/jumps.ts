import type { Direction } from '../../grid/directions'
import type { Cell } from '../../grid/grid'
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

  constructor(
    legal: Uint8Array,
    successors: Uint8Array,
    offsets: Int32Array,
    diagonalWeight: number,
    goal: Cell,
    memory: Memory,
  ) {
    this.#legal = legal
    this.#successors = successors
    this.#offsets = offsets
    this.#diagonalWeight = diagonalWeight
    this.#goal = goal
    this.#memory = memory
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
      const next = d & 1 ? this.#diagonally(cell, d) : this.#straight(cell, d)
      if (next < 0) return -1
      length += ((next - cell) / this.#offsets[d]) * (d & 1 ? this.#diagonalWeight : 1)
      cell = next
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

  /** The first cell with another way than onward, or the goal; -1 if the way ends before. */
  #straight(from: Cell, d: Direction): Cell {
    const legal = this.#legal
    const successors = this.#successors
    const goal = this.#goal
    const offset = this.#offsets[d]
    const row = d << 8
    const onward = 1 << d
    let cell = from
    let ways = onward
    while (ways === onward) {
      cell += offset
      if (cell === goal) return cell
      ways = successors[row | legal[cell]]
    }
    return ways === 0 ? -1 : cell
  }

  /** The first cell round an obstacle's corner, or with a jump point straight to a side; or the goal. */
  #diagonally(from: Cell, d: Direction): Cell {
    const legal = this.#legal
    const successors = this.#successors
    const goal = this.#goal
    const offset = this.#offsets[d]
    const row = d << 8
    const onward = 1 << d
    const left = (d + 7) & 7
    const right = (d + 1) & 7
    const natural = onward | (1 << left) | (1 << right)
    let cell = from
    let ways = onward
    while ((ways & onward) !== 0) {
      cell += offset
      ways = successors[row | legal[cell]]
      if (cell === goal || (ways & ~natural) !== 0) return cell
      if ((ways >> left) & 1 && this.#straight(cell, left) >= 0) return cell
      if ((ways >> right) & 1 && this.#straight(cell, right) >= 0) return cell
    }
    return -1
  }
}
