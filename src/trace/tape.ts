import { InputError } from '../grid/errors'
import { type Cell, isInside } from '../grid/grid'
import type { EventKind } from './events'
import { CHUNK, CHUNK_BITS, EVENT_WORDS, FIRST_ROOM, PLACE } from './tape-layout'
import { LEFT_OUT, type Thinning } from './thinning'

/**
 * So many events make 80 MB, and 160 if all have values. A tape that comes to so many leaves out what
 * is small from its first event on; if that is not enough, all that comes later.
 */
const MOST_EVENTS = 10_000_000

// Of a tape that has no chunk yet, and of a chunk whose values are all 0.
const NO_WORDS = new Int32Array(0)
const NO_VALUES = new Float64Array(0)

/** What a tape is made of: all that there is to be sent to another thread. */
export interface TapeData {
  /** Size of the map in cells. */
  readonly width: number
  readonly height: number
  /** What a diagonal step costs, a straight one being 1. */
  readonly diagonalCost: number
  readonly thinning: Thinning
  readonly length: number
  /** The events, in chunks of one size, the last one as long as it must be. */
  readonly words: readonly Int32Array<ArrayBuffer>[]
  /** Their values, chunk by chunk in the same way; empty where all are 0. */
  readonly values: readonly Float64Array<ArrayBuffer>[]
  /** The memory of both, to be transferred. */
  readonly buffers: ArrayBuffer[]
}

/** What a planner did, event by event. Writing allocates nothing per event. */
export class Tape {
  width = 0
  height = 0
  diagonalCost = 1
  thinning: Thinning = 'whole'
  readonly #most: number
  /** Where the planner is in its pseudocode; every event is stamped with it. */
  #line = 0
  /** The chunks, and their values. */
  #chunks: Int32Array<ArrayBuffer>[] = []
  #chunkValues: Float64Array<ArrayBuffer>[] = []
  /** The chunk that is written on, and how many events it has. */
  #chunk = 0
  #words = NO_WORDS
  #values = NO_VALUES
  #used = 0
  /** While the chunk has fewer events than this, writing needs no thought. */
  #easy = 0

  /**
   * @param most how many events there may be before some are left out, a whole number from 1
   * @throws InputError if it is not
   */
  constructor(most = MOST_EVENTS) {
    if (!Number.isSafeInteger(most) || most < 1) {
      throw new InputError(
        `A tape cannot have at most ${most} events: a whole number from 1 is needed.`,
      )
    }
    this.#most = most
  }

  /** A tape of what another one handed over, in this thread or another. */
  static from({ width, height, diagonalCost, thinning, length, words, values }: TapeData): Tape {
    const tape = new Tape()
    tape.width = width
    tape.height = height
    tape.diagonalCost = diagonalCost
    tape.thinning = thinning
    tape.#chunks = [...words]
    tape.#chunkValues = [...values]
    tape.#goTo(length)
    return tape
  }

  /**
   * Forgets what is written and starts anew for a map of this size.
   * @param diagonalCost what a diagonal step costs, a straight one being 1
   */
  begin(width: number, height: number, diagonalCost = 1): void {
    this.width = width
    this.height = height
    this.diagonalCost = diagonalCost
    this.thinning = 'whole'
    this.#line = 0
    this.#goTo(0)
  }

  get length(): number {
    return (this.#chunk << CHUNK_BITS) + this.#used
  }

  // What is written in the event of a number from 0 up to the length.
  kind(event: number): EventKind {
    const word = this.#chunks[event >> CHUNK_BITS][(event & PLACE) * EVENT_WORDS]
    return (word & 255) as EventKind
  }

  /** Line of the planner's pseudocode, counted from 0. */
  line(event: number): number {
    return this.#chunks[event >> CHUNK_BITS][(event & PLACE) * EVENT_WORDS + 1] & 255
  }

  cell(event: number): Cell {
    return this.#chunks[event >> CHUNK_BITS][(event & PLACE) * EVENT_WORDS] >> 8
  }

  other(event: number): number {
    return this.#chunks[event >> CHUNK_BITS][(event & PLACE) * EVENT_WORDS + 1] >> 8
  }

  value(event: number): number {
    const values = this.#chunkValues[event >> CHUNK_BITS]
    const place = event & PLACE
    return place < values.length ? values[place] : 0
  }

  /**
   * The last of the first `before` events of which `holds` is true, among those at a cell whose
   * number is at most `reach` away from that of `cell`; -1 if there is none. Millions of events
   * elsewhere are passed over in milliseconds.
   */
  findLast(before: number, cell: Cell, reach: number, holds: (event: number) => boolean): number {
    const least = (cell - reach) << 8
    const most = ((cell + reach) << 8) | 255
    for (let chunk = (before - 1) >> CHUNK_BITS; chunk >= 0; chunk--) {
      const words = this.#chunks[chunk]
      const first = chunk << CHUNK_BITS
      for (let i = Math.min(before - first, CHUNK) - 1; i >= 0; i--) {
        const word = words[i * EVENT_WORDS]
        if (word >= least && word <= most && holds(first + i)) return first + i
      }
    }
    return -1
  }

  /** The cell at (x, y); -1 outside the map. */
  cellAt(x: number, y: number): Cell {
    return isInside(this, x, y) ? y * this.width + x : -1
  }

  /** Says that the planner is at this line of its pseudocode, counted from 0. */
  at(line: number): this {
    this.#line = line
    return this
  }

  write(kind: EventKind, cell: Cell = -1, other = -1, value = 0): void {
    this.writeAt(this.#line, kind, cell, other, value)
  }

  /** The same at another line, for inner loops; the planner stays where it is. */
  writeAt(line: number, kind: EventKind, cell: Cell, other: number, value: number): void {
    if (this.#used >= this.#easy && !this.#makeRoomFor(kind)) return
    const i = this.#used
    const words = this.#words
    words[i * EVENT_WORDS] = (cell << 8) | kind
    words[i * EVENT_WORDS + 1] = (other << 8) | line
    if (i < this.#values.length) this.#values[i] = value
    else if (value !== 0) this.#makeRoomForValues()[i] = value
    this.#used = i + 1
  }

  /** Hands over all that is written. The tape is empty then. */
  release(): TapeData {
    const { width, height, diagonalCost, thinning, length } = this
    const count = Math.ceil(length / CHUNK)
    // What is not written of the last chunk is left out.
    const rest = length - (count - 1) * CHUNK
    const isCut = (chunk: number) => chunk === count - 1 && rest < CHUNK
    const words = this.#chunks
      .slice(0, count)
      .map((words, chunk) => (isCut(chunk) ? words.slice(0, rest * EVENT_WORDS) : words))
    const values = this.#chunkValues
      .slice(0, count)
      .map((values, chunk) => (isCut(chunk) ? values.slice(0, rest) : values))
    this.#chunks = []
    this.#chunkValues = []
    this.begin(width, height, diagonalCost)
    const buffers = [...words, ...values].filter((chunk) => chunk.length > 0)
    return {
      ...{ width, height, diagonalCost, thinning, length, words, values },
      buffers: buffers.map(({ buffer }) => buffer),
    }
  }

  /** Room for the values of the chunk that is written on, which were all 0. */
  #makeRoomForValues(): Float64Array<ArrayBuffer> {
    const values = new Float64Array(this.#words.length / EVENT_WORDS)
    values.set(this.#values)
    this.#values = values
    this.#chunkValues[this.#chunk] = values
    return values
  }

  /** Whether an event of this kind is to be written; if so, there is room for it then. */
  #makeRoomFor(kind: EventKind): boolean {
    while (!LEFT_OUT[this.thinning][kind]) {
      if (this.length >= this.#most) this.#leaveOutMore()
      else {
        if (this.#used * EVENT_WORDS === this.#words.length) this.#grow()
        return true
      }
    }
    return false
  }

  /** Goes on behind so many events. */
  #goTo(length: number): void {
    const chunk = length >> CHUNK_BITS
    this.#chunk = chunk
    this.#used = length & PLACE
    this.#words = this.#chunks[chunk] ?? NO_WORDS
    this.#values = this.#chunkValues[chunk] ?? NO_VALUES
    const room = Math.min(this.#words.length / EVENT_WORDS, this.#most - chunk * CHUNK)
    this.#easy = this.thinning === 'whole' ? room : 0
  }

  /** Makes room behind a chunk that is full, or that was handed over as long as it had to be. */
  #grow(): void {
    const { length } = this
    const chunk = length >> CHUNK_BITS
    const before = this.#chunks[chunk]
    if (before === undefined || before.length < CHUNK * EVENT_WORDS) {
      const first = length === 0 ? FIRST_ROOM : CHUNK
      const room = before ? Math.min(CHUNK, (2 * before.length) / EVENT_WORDS) : first
      this.#chunks[chunk] = new Int32Array(room * EVENT_WORDS)
      this.#chunkValues[chunk] ??= NO_VALUES
      if (before) this.#chunks[chunk].set(before)
    }
    this.#goTo(length)
  }

  #leaveOutMore(): void {
    const { length } = this
    if (this.thinning === 'whole') {
      this.thinning = 'thinned'
      this.#goTo(0)
      // Written anew, without what is left out now; no event gets behind where it was.
      for (let i = 0; i < length; i++) {
        const kind = this.kind(i)
        if (LEFT_OUT.thinned[kind]) continue
        this.writeAt(this.line(i), kind, this.cell(i), this.other(i), this.value(i))
      }
    } else {
      this.thinning = 'cut'
      // Room for the one event that is still to come, the end.
      this.#goTo(length - 1)
    }
  }
}
