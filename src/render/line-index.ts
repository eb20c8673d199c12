import type { Cell } from '../grid/grid'
import { larger } from '../grid/larger'
import { BLOCK, BlockIndex } from './block-index'
import type { Box } from './box'
import { boxInView, MOST_IN_VIEW, mayBeSeen, type Placement } from './placement'

const FIRST_ROOM = 1024

/** Straight lines between cells. Those on the screen are found quickly, even among millions. */
export class LineIndex {
  readonly #columns: number
  /** Pairs of cells. Long ones are kept apart; they do not overlap, so that a map has few of them. */
  #short = new Int32Array(FIRST_ROOM)
  readonly #long: Cell[] = []
  /** The short lines by their first cells. */
  readonly #blocks: BlockIndex

  constructor(columns: number, rows: number) {
    this.#columns = columns
    this.#blocks = new BlockIndex(columns, rows)
  }

  get length(): number {
    return this.#blocks.length + this.#long.length / 2
  }

  add(from: Cell, to: Cell): void {
    const columns = this.#columns
    const dx = (to % columns) - (from % columns)
    const dy = Math.floor(to / columns) - Math.floor(from / columns)
    if (Math.max(Math.abs(dx), Math.abs(dy)) >= BLOCK) {
      this.#long.push(from, to)
      return
    }
    const at = 2 * this.#blocks.length
    if (at === this.#short.length) this.#grow()
    this.#short[at] = from
    this.#short[at + 1] = to
    this.#blocks.add(from)
  }

  /** Pairs of cells: the lines that may be seen; `null` if they are too many to be told apart. */
  inView(place: Placement): Cell[] | null {
    const box = boxInView(place, 1)
    if (this.#blocks.estimate(box) > MOST_IN_VIEW) return null
    const lines: Cell[] = []
    const short = this.#short
    this.#blocks.visit(widened(box), (i) => {
      if (mayBeSeen(place, short[2 * i], short[2 * i + 1]))
        lines.push(short[2 * i], short[2 * i + 1])
    })
    const long = this.#long
    for (let i = 0; i < long.length; i += 2) {
      if (mayBeSeen(place, long[i], long[i + 1])) lines.push(long[i], long[i + 1])
    }
    return lines.length > 2 * MOST_IN_VIEW ? null : lines
  }

  #grow(): void {
    this.#short = larger(this.#short, new Int32Array(2 * this.#short.length))
  }
}

/** The box with all cells around it from which a short line may reach into it. */
const widened = ({ left, top, right, bottom }: Box): Box => ({
  left: left - BLOCK,
  top: top - BLOCK,
  right: right + BLOCK,
  bottom: bottom + BLOCK,
})
