import type { Cell } from '../../grid/grid'
import { larger } from '../../grid/larger'

const ROOM = 256

/** Cells that wait, in the order in which they came. Emptied by setting its count to 0. */
export class Bucket {
  cells = new Int32Array(ROOM)
  count = 0

  push(cell: Cell): void {
    if (this.count === this.cells.length) this.makeRoom(1)
    this.cells[this.count++] = cell
  }

  /** For so many more cells. */
  makeRoom(more: number): void {
    if (this.count + more > this.cells.length) this.#grow(2 * (this.count + more))
  }

  /** By itself: searches are the quicker for not having it in their loops. */
  #grow(room: number): void {
    this.cells = larger(this.cells, new Int32Array(room))
  }
}
