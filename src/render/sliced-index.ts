import { isSameSize } from '../grid/grid'
import type { Cells } from '../trace/frame'
import type { Tape } from '../trace/tape'
import { runFor, type Work } from './work'

/** Makes an index of a list that only grows. */
export interface Indexer<Index> {
  /** The index of the first `length` entries; those that it had before are the same. */
  take(list: Cells, length: number): Work<Index>
}

/**
 * The index of a list in the frames of a tape, which only grows. Work that takes long is done a slice
 * at a time. Until it is done, the index from before is the one to be shown, and what is added to the
 * list meanwhile waits.
 */
export class SlicedIndex<Index> {
  readonly #newIndexer: (columns: number, rows: number) => Indexer<Index>
  #ready: Index | null = null
  #readyLength = 0
  #indexer: Indexer<Index> | null = null
  #tape: Tape | null = null
  /** How many entries of the list the indexer has taken, or is at work on. */
  #length = 0
  #work: Work<void> | null = null

  constructor(newIndexer: (columns: number, rows: number) => Indexer<Index>) {
    this.#newIndexer = newIndexer
  }

  /** `null` while there is nothing to show. */
  get ready(): Index | null {
    return this.#ready
  }

  /** How many entries of the list the index has. */
  get readyLength(): number {
    return this.#readyLength
  }

  /** Goes on for as long as there is time; returns whether all of the list is in the index. */
  update(tape: Tape | null, list: Cells, isTimeUp: () => boolean): boolean {
    if (!tape || list.length === 0) {
      this.#clear()
      return true
    }
    if (tape !== this.#tape) this.#beginOn(tape)
    while (this.#work || list.length !== this.#length) {
      this.#work ??= this.#workOn(tape, list)
      if (!runFor(this.#work, isTimeUp)) return false
      this.#work = null
    }
    return true
  }

  #clear(): void {
    this.#ready = null
    this.#readyLength = 0
    this.#indexer = null
    this.#tape = null
    this.#length = 0
    this.#work = null
  }

  #beginOn(tape: Tape): void {
    // The index of the plan before is shown until this one has its own, unless the map has another size.
    if (!this.#tape || !isSameSize(tape, this.#tape)) this.#clear()
    this.#tape = tape
    this.#indexer = null
    this.#length = 0
    this.#work = null
  }

  *#workOn(tape: Tape, list: Cells): Work<void> {
    const { length } = list
    if (length < this.#length) this.#indexer = null
    this.#length = length
    this.#indexer ??= this.#newIndexer(tape.width, tape.height)
    this.#ready = yield* this.#indexer.take(list, length)
    this.#readyLength = length
  }
}
