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
    const room = this.count + more
    if (room > this.cells.length) this.cells = larger(this.cells, new Int32Array(2 * room))
  }
}
