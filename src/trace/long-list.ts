import type { Cell } from '../grid/grid'

const FIRST_ROOM = 16

/**
 * Adds to a list of which there may be millions. The memory of the list has room behind its end, and
 * is shared by all frames of a tape: whichever of them comes to a place first writes what the others
 * would, for their lists only grow and are the same as far as they go. So to copy a list takes no time.
 */
export class LongList {
  #cells: Int32Array
  #length: number

  constructor(list: Int32Array) {
    this.#cells = new Int32Array(list.buffer)
    this.#length = list.length
  }

  /** The cells so far; those that come later are not among them. */
  get cells(): Int32Array {
    return this.#cells.subarray(0, this.#length)
  }

  push(cell: Cell): void {
    if (this.#length === this.#cells.length) this.#grow()
    this.#cells[this.#length++] = cell
  }

  #grow(): void {
    const grown = new Int32Array(Math.max(FIRST_ROOM, 2 * this.#length))
    grown.set(this.#cells)
    this.#cells = grown
  }
}
