import type { Cell } from '../grid/grid'
import type { EventKind } from './events'
import { LEFT_OUT, type Thinning } from './thinning'

const FIRST_ROOM = 1024

/**
 * So many events make about 180 MB. A tape that comes to so many leaves out what is small from its
 * first event on; if that is not enough, all that comes later.
 */
const MOST_EVENTS = 10_000_000

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
  kinds = new Uint8Array(FIRST_ROOM)
  lines = new Uint8Array(FIRST_ROOM)
  cells = new Int32Array(FIRST_ROOM)
  others = new Int32Array(FIRST_ROOM)
  values = new Float64Array(FIRST_ROOM)
  thinning: Thinning = 'whole'
  readonly #most: number
  /** While there are fewer events than this, writing needs no thought. */
  #easy = FIRST_ROOM
  /** Where the planner is in its pseudocode; every event is stamped with it. */
  line = 0

  /** @param most how many events there may be before some are left out */
  constructor(most = MOST_EVENTS) {
    this.#most = most
  }

  /** A tape around columns that came from a worker. */
  static from(columns: TapeColumns): Tape {
    const tape = Object.assign(new Tape(), columns)
    tape.#markEasy()
    return tape
  }

  /** Forgets what is written and starts anew for a map of this size. */
  begin(width: number, height: number): void {
    this.width = width
    this.height = height
    this.length = 0
    this.line = 0
    this.#thin('whole')
  }

  /** Makes room for so many more events at once: growing bit by bit takes longer than writing. */
  reserve(events: number): void {
    const room = Math.min(this.length + events, this.#most)
    if (room > this.kinds.length) this.#resize(room)
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
    if (this.length >= this.#easy && !this.#makeRoomFor(kind)) return
    const i = this.length
    this.kinds[i] = kind
    this.lines[i] = this.line
    this.cells[i] = cell
    this.others[i] = other
    this.values[i] = value
    this.length = i + 1
  }

  /** An event of this kind for each cell of the map, one after the other, with the cell's value. */
  writeField(kind: EventKind, field: Float64Array): void {
    const from = this.length
    const to = from + field.length
    if (this.thinning !== 'whole' || to > this.#most) {
      for (let cell = 0; cell < field.length; cell++) this.write(kind, cell, -1, field[cell])
      return
    }
    this.reserve(field.length)
    this.kinds.fill(kind, from, to)
    this.lines.fill(this.line, from, to)
    for (let cell = 0; cell < field.length; cell++) this.cells[from + cell] = cell
    this.others.fill(-1, from, to)
    this.values.set(field, from)
    this.length = to
  }

  /** Hands over the columns, and the buffers to transfer with them. The tape is empty then. */
  release(): { columns: TapeColumns; buffers: ArrayBuffer[] } {
    if (this.length < this.kinds.length / 2) this.#resize(this.length)
    const { width, height, length, thinning, kinds, lines, cells, others, values } = this
    const columns = { width, height, length, thinning, kinds, lines, cells, others, values }
    Object.assign(this, new Tape(this.#most))
    this.begin(width, height)
    return { columns, buffers: [kinds, lines, cells, others, values].map((c) => c.buffer) }
  }

  /** Whether an event of this kind is to be written; if so, there is room for it then. */
  #makeRoomFor(kind: EventKind): boolean {
    while (!LEFT_OUT[this.thinning][kind]) {
      if (this.length < this.kinds.length) return true
      this.#grow()
    }
    return false
  }

  #markEasy(): void {
    this.#easy = this.thinning === 'whole' ? this.kinds.length : 0
  }

  #grow(): void {
    const { length } = this
    if (length < this.#most) this.#resize(Math.min(Math.max(2 * length, FIRST_ROOM), this.#most))
    else if (this.thinning === 'whole') this.#thin('thinned')
    else {
      this.#thin('cut')
      // Room for the one event that is still to come, the end.
      this.length--
    }
  }

  #thin(thinning: Thinning): void {
    this.thinning = thinning
    this.#markEasy()
    if (thinning !== 'thinned') return
    const leftOut = LEFT_OUT[thinning]
    let kept = 0
    for (let i = 0; i < this.length; i++) {
      if (leftOut[this.kinds[i]]) continue
      this.kinds[kept] = this.kinds[i]
      this.lines[kept] = this.lines[i]
      this.cells[kept] = this.cells[i]
      this.others[kept] = this.others[i]
      this.values[kept] = this.values[i]
      kept++
    }
    this.length = kept
  }

  #resize(room: number): void {
    const { kinds, lines, cells, others, values, length } = this
    this.kinds = copied(kinds, new Uint8Array(room), length)
    this.lines = copied(lines, new Uint8Array(room), length)
    this.cells = copied(cells, new Int32Array(room), length)
    this.others = copied(others, new Int32Array(room), length)
    this.values = copied(values, new Float64Array(room), length)
    this.#markEasy()
  }
}

function copied<Column extends Uint8Array | Int32Array | Float64Array>(
  from: Column,
  to: Column,
  length: number,
): Column {
  to.set(from.subarray(0, length))
  return to
}
