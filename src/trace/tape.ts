import type { Cell } from '../grid/grid'
import type { EventKind } from './events'

/** What a long tape leaves out: nothing; small events, all along; these, and what came at its end. */
export type Thinning = 'whole' | 'thinned' | 'cut'

/** The columns of a tape, one entry an event; the arrays may be longer than `length`. */
export interface TapeColumns {
  /** Size of the map in cells. */
  readonly width: number
  readonly height: number
  readonly length: number
  readonly kinds: Uint8Array
  /** Line of the planner's pseudocode, counted from 0. */
  readonly lines: Uint8Array
  readonly cells: Int32Array
  readonly others: Int32Array
  readonly values: Float64Array
  readonly thinning: Thinning
}

/**
 * What a planner did, event by event. Kept as columns so that writing allocates nothing per event
 * and a worker can hand it over without a copy.
 */
export class Tape implements TapeColumns {
  width = 0
  height = 0
  length = 0
  kinds = new Uint8Array(1024)
  lines = new Uint8Array(1024)
  cells = new Int32Array(1024)
  others = new Int32Array(1024)
  values = new Float64Array(1024)
  thinning: Thinning = 'whole'
  /** Where the planner is in its pseudocode; every event is stamped with it. */
  line = 0

  /** A tape around columns that came from a worker. */
  static from(columns: TapeColumns): Tape {
    return Object.assign(new Tape(), columns)
  }

  /** Forgets what is written and starts anew for a map of this size. */
  begin(width: number, height: number): void {
    this.width = width
    this.height = height
    this.length = 0
    this.line = 0
    this.thinning = 'whole'
  }

  /** The cell at (x, y); -1 outside the map. */
  cellAt(x: number, y: number): Cell {
    const inside = x >= 0 && y >= 0 && x < this.width && y < this.height
    return inside ? y * this.width + x : -1
  }

  /** Says that the planner is at this line of its pseudocode, counted from 0. */
  at(line: number): this {
    this.line = line
    return this
  }

  write(kind: EventKind, cell: Cell = -1, other = -1, value = 0): void {
    const i = this.length
    if (i === this.kinds.length) this.grow()
    this.kinds[i] = kind
    this.lines[i] = this.line
    this.cells[i] = cell
    this.others[i] = other
    this.values[i] = value
    this.length = i + 1
  }

  /** The columns without the room kept for more, and the buffers to transfer with them. */
  release(): { columns: TapeColumns; buffers: ArrayBuffer[] } {
    const { width, height, length, thinning } = this
    const columns = {
      width,
      height,
      length,
      thinning,
      kinds: this.kinds.slice(0, length),
      lines: this.lines.slice(0, length),
      cells: this.cells.slice(0, length),
      others: this.others.slice(0, length),
      values: this.values.slice(0, length),
    }
    const { kinds, lines, cells, others, values } = columns
    return { columns, buffers: [kinds, lines, cells, others, values].map((c) => c.buffer) }
  }

  private grow(): void {
    const double = <T extends Uint8Array | Int32Array | Float64Array>(from: T, to: T): T => {
      to.set(from)
      return to
    }
    // The columns of a released tape have no room at all, maybe not even a first event.
    const size = Math.max(2 * this.kinds.length, 1024)
    this.kinds = double(this.kinds, new Uint8Array(size))
    this.lines = double(this.lines, new Uint8Array(size))
    this.cells = double(this.cells, new Int32Array(size))
    this.others = double(this.others, new Int32Array(size))
    this.values = double(this.values, new Float64Array(size))
  }
}
