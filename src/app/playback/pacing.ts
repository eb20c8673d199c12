import { EVENT } from '../../trace/events'
import type { Tape } from '../../trace/tape'

/** Share of the time for searches and fields, if something moves after them. */
const SEARCH_SHARE = 0.45

const MOVES: ReadonlySet<number> = new Set([EVENT.step, EVENT.path])

const SEARCHES: ReadonlySet<number> = new Set([
  EVENT.row,
  EVENT.test,
  EVENT.vertex,
  EVENT.edge,
  EVENT.refuse,
  EVENT.open,
  EVENT.close,
  EVENT.attraction,
  EVENT.repulsion,
  EVENT.potential,
])

/**
 * Plays a tape so that it can be followed: a search of thousands of events takes about as long as
 * the path of a few cells that comes out of it, and a rover goes at an even speed however much it
 * senses on its way.
 */
export class Pace {
  readonly #tape: Tape
  /** How much of the time an event takes, by its kind. */
  readonly #weights = new Float64Array(256)
  #time = 0
  #done = 0

  constructor(tape: Tape) {
    this.#tape = tape
    const counts = new Uint32Array(256)
    for (let i = 0; i < tape.length; i++) counts[tape.kind(i)]++
    const sum = (kinds: ReadonlySet<number>) =>
      [...kinds].reduce((total, kind) => total + counts[kind], 0)
    const [moves, searches] = [sum(MOVES), sum(SEARCHES)]
    const searchShare = searches === 0 ? 0 : moves === 0 ? 1 : SEARCH_SHARE
    for (const kind of SEARCHES) this.#weights[kind] = searchShare / Math.max(1, searches)
    for (const kind of MOVES) this.#weights[kind] = (1 - searchShare) / Math.max(1, moves)
  }

  /** Begins after so many events. Returns what share of the time is over by then. */
  beginAt(time: number): number {
    this.#time = 0
    this.#done = 0
    while (this.#time < time) this.#next()
    return this.#done
  }

  /** How many events have happened when `share` of the time is over. Shares must not fall. */
  timeAt(share: number): number {
    const { length } = this.#tape
    if (share >= 1) this.#time = length
    while (this.#time < length && this.#done < share) this.#next()
    return this.#time
  }

  #next(): void {
    this.#done += this.#weights[this.#tape.kind(this.#time)]
    this.#time++
  }
}
