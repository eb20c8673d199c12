import FlatQueue from 'flatqueue'
import type { Cell } from '../../grid/grid'
import { larger } from '../../grid/larger'
import { Bucket } from './bucket'

const SLOTS = 1 << 10
const ROOM = 1 << 10
/** So few slots are quicker cleared one by one. */
const FEW = 1 << 8
const NONE = -1

/**
 * The open cells of A*, by the weight of the least path over them. Few weights differ, so cells of
 * equal weight make a chain, and only the heads of chains go through a heap. Among equals it is the
 * latest that come first: they are furthest on their way.
 *
 * What is taken out never weighs less than what was taken out before it, and what is put in neither.
 */
export class OpenCells {
  /** The weight of the cell that was taken out last. */
  #least = 0
  /** Cells of the least weight that were put in while it was the least. */
  readonly #latest = new Bucket()
  /** What is left of the chain of the least weight. */
  #chain = NONE
  readonly #heads = new FlatQueue<number>()
  /** By slot the weight of the latest chain that fell into it, and that chain's head. */
  readonly #weights = new Float64Array(SLOTS).fill(Number.NaN)
  readonly #headOf = new Int32Array(SLOTS)
  /** How often a slot was written into, and the first of those. */
  #written = 0
  readonly #slots = new Int16Array(FEW)
  /** By link of a chain its cell and the next link. */
  #cells = new Int32Array(ROOM)
  #next = new Int32Array(ROOM)
  #links = 0
  #unused = NONE

  /** Only `first` is open, and it weighs so much. */
  begin(first: Cell, weight: number): void {
    this.#least = weight
    this.#latest.count = 0
    this.#chain = NONE
    this.#heads.clear()
    this.#clearSlots()
    this.#links = 0
    this.#unused = NONE
    this.push(first, weight)
  }

  push(cell: Cell, weight: number): void {
    if (weight === this.#least) {
      this.#latest.push(cell)
      return
    }
    const link = this.#newLink(cell)
    const slot = slotOf(weight)
    if (this.#weights[slot] === weight) {
      const head = this.#headOf[slot]
      this.#next[link] = this.#next[head]
      this.#next[head] = link
      return
    }
    // Weights that share a slot may get a chain more than they need, and no harm is done.
    if (this.#written < FEW) this.#slots[this.#written] = slot
    this.#written++
    this.#weights[slot] = weight
    this.#headOf[slot] = link
    this.#next[link] = NONE
    this.#heads.push(link, weight)
  }

  /** Takes out the first of the cells; -1 if there is none. */
  pop(): Cell {
    const latest = this.#latest
    if (latest.count > 0) return latest.cells[--latest.count]
    let link = this.#chain
    if (link === NONE) {
      const least = this.#heads.peekValue()
      const head = this.#heads.pop()
      if (least === undefined || head === undefined) return -1
      this.#least = least
      link = head
    }
    this.#chain = this.#next[link]
    this.#next[link] = this.#unused
    this.#unused = link
    return this.#cells[link]
  }

  #clearSlots(): void {
    if (this.#written > FEW) this.#weights.fill(Number.NaN)
    else for (let i = 0; i < this.#written; i++) this.#weights[this.#slots[i]] = Number.NaN
    this.#written = 0
  }

  #newLink(cell: Cell): number {
    let link = this.#unused
    if (link === NONE) {
      link = this.#links++
      if (link === this.#cells.length) this.#grow()
    } else this.#unused = this.#next[link]
    this.#cells[link] = cell
    return link
  }

  #grow(): void {
    const room = 2 * this.#cells.length
    this.#cells = larger(this.#cells, new Int32Array(room))
    this.#next = larger(this.#next, new Int32Array(room))
  }
}

/** Weights are multiples of 2^-30 that seldom differ in the last bits only: other bits tell them apart. */
const slotOf = (weight: number): number => ((weight * (2 ** 23 + 509)) | 0) & (SLOTS - 1)
