import FlatQueue from 'flatqueue'
import type { Cell } from '../../grid/grid'

const SLOTS = 1 << 12
const ROOM = 1 << 10
const NONE = -1

/**
 * The open cells of A*, by the weight of the least path over them; among equals the latest comes
 * first. Few weights differ, so equal ones share a stack, and only stacks go through a heap.
 *
 * What is asked for never falls: a cell may not be put in below `least`.
 */
export class OpenCells {
  /** The weight by which the latest cell was taken. */
  least = 0
  #stack = 0
  #stacks = 0
  readonly #heap = new FlatQueue<number>()
  /** The stack that was last begun for a weight that falls into a slot. */
  readonly #weights = new Float64Array(SLOTS)
  readonly #stackOf = new Int32Array(SLOTS)
  /** By stack the entry on its top; by entry its cell and the entry below. */
  #tops = new Int32Array(ROOM)
  #cells = new Int32Array(ROOM)
  #below = new Int32Array(ROOM)
  #entries = 0
  #unused = NONE

  /** Only `first` is open, and it weighs so much. */
  begin(first: Cell, weight: number): void {
    this.least = weight
    this.#stack = 0
    this.#stacks = 1
    this.#tops[0] = NONE
    this.#heap.clear()
    this.#weights.fill(Number.NaN)
    this.#entries = 0
    this.#unused = NONE
    this.push(first, weight)
  }

  push(cell: Cell, weight: number): void {
    const stack = weight === this.least ? this.#stack : this.#stackFor(weight)
    let entry = this.#unused
    if (entry === NONE) {
      entry = this.#entries++
      if (entry === this.#cells.length) this.#grow()
    } else this.#unused = this.#below[entry]
    this.#cells[entry] = cell
    this.#below[entry] = this.#tops[stack]
    this.#tops[stack] = entry
  }

  /** Takes out the first of the cells; -1 if there is none. */
  pop(): Cell {
    let top = this.#tops[this.#stack]
    while (top === NONE) {
      const least = this.#heap.peekValue()
      const next = this.#heap.pop()
      if (least === undefined || next === undefined) return -1
      this.least = least
      this.#stack = next
      top = this.#tops[next]
    }
    this.#tops[this.#stack] = this.#below[top]
    this.#below[top] = this.#unused
    this.#unused = top
    return this.#cells[top]
  }

  /** Weights that share a slot may get a stack more than they need, and no harm is done. */
  #stackFor(weight: number): number {
    const whole = Math.floor(weight)
    const slot = (whole * 1021 + (weight - whole) * 2 ** 23) & (SLOTS - 1)
    if (this.#weights[slot] === weight) return this.#stackOf[slot]
    const stack = this.#stacks++
    if (stack === this.#tops.length) this.#tops = doubled(this.#tops)
    this.#tops[stack] = NONE
    this.#weights[slot] = weight
    this.#stackOf[slot] = stack
    this.#heap.push(stack, weight)
    return stack
  }

  #grow(): void {
    this.#cells = doubled(this.#cells)
    this.#below = doubled(this.#below)
  }
}

function doubled(array: Int32Array<ArrayBuffer>): Int32Array<ArrayBuffer> {
  const more = new Int32Array(2 * array.length)
  more.set(array)
  return more
}
