import type { Cell } from '../grid/grid'
import { larger } from '../grid/larger'
import type { Box } from './box'

/** Side of a block in cells. */
export const BLOCK = 64

const FIRST_ROOM = 1024

/** Things in the cells of a map, numbered in the order they are added, and found again by blocks of cells. */
export class BlockIndex {
  /** How many things there are. */
  length = 0
  readonly #mapColumns: number
  readonly #columns: number
  readonly #rows: number
  readonly #counts: Int32Array
  /** For each block the latest thing in it, and for each thing the one before it in its block. */
  readonly #latest: Int32Array
  #before = new Int32Array(FIRST_ROOM)

  constructor(mapColumns: number, mapRows: number) {
    this.#mapColumns = mapColumns
    this.#columns = Math.ceil(mapColumns / BLOCK)
    this.#rows = Math.ceil(mapRows / BLOCK)
    this.#counts = new Int32Array(this.#columns * this.#rows)
    this.#latest = new Int32Array(this.#columns * this.#rows).fill(-1)
  }

  /** The next thing lies in this cell. */
  add(cell: Cell): void {
    const x = cell % this.#mapColumns
    const y = (cell - x) / this.#mapColumns
    const block = Math.floor(y / BLOCK) * this.#columns + Math.floor(x / BLOCK)
    if (this.length === this.#before.length) this.#grow()
    this.#before[this.length] = this.#latest[block]
    this.#latest[block] = this.length
    this.#counts[block]++
    this.length++
  }

  /** About how many things lie in the box: where it cuts a block, things count in proportion to cells. */
  estimate(box: Box): number {
    let sum = 0
    this.#eachBlock(box, (block, column, row) => {
      const width = overlap(column * BLOCK, box.left, box.right)
      const height = overlap(row * BLOCK, box.top, box.bottom)
      sum += (this.#counts[block] * width * height) / (BLOCK * BLOCK)
    })
    return sum
  }

  /** Visits all things in the blocks that the box touches; some of them may lie outside the box. */
  visit(box: Box, each: (thing: number) => void): void {
    this.#eachBlock(box, (block) => {
      for (let i = this.#latest[block]; i >= 0; i = this.#before[i]) each(i)
    })
  }

  #eachBlock(
    { left, top, right, bottom }: Box,
    each: (block: number, column: number, row: number) => void,
  ): void {
    const toColumn = Math.min(this.#columns, Math.ceil(right / BLOCK))
    const toRow = Math.min(this.#rows, Math.ceil(bottom / BLOCK))
    for (let row = Math.max(0, Math.floor(top / BLOCK)); row < toRow; row++) {
      for (let column = Math.max(0, Math.floor(left / BLOCK)); column < toColumn; column++) {
        each(row * this.#columns + column, column, row)
      }
    }
  }

  #grow(): void {
    this.#before = larger(this.#before, new Int32Array(2 * this.#before.length))
  }
}

const overlap = (start: number, from: number, to: number): number =>
  Math.min(start + BLOCK, to) - Math.max(start, from)
