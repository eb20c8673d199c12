import type { Cell } from '../grid/grid'
import { larger } from '../grid/larger'

const FIRST_ROOM = 16

/**
 * Adds to a list that may have millions of entries. The buffer of a list has room behind its end, and
 * all frames of a tape share it, so that copying a list takes no time. That is safe, because lists
 * only grow: what one frame writes behind the end of another's list is what that one would write too.
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
    const room = Math.max(FIRST_ROOM, 2 * this.#length)
    this.#cells = larger(this.#cells, new Int32Array(room))
  }
}
