import { EVENT } from '../trace/events'
import type { TapeColumns } from '../trace/tape'

/** Share of the time that belongs to search and field, if something moves after them. */
const SEARCH_SHARE = 0.45

const isMove = (kind: number): boolean => kind === EVENT.step || kind === EVENT.path

const isSearch = (kind: number): boolean =>
  kind === EVENT.open ||
  kind === EVENT.close ||
  kind === EVENT.vertex ||
  kind === EVENT.edge ||
  kind === EVENT.potential

/**
 * Plays a tape so that it can be followed: a search of thousands of events takes about as long as
 * the path of a few cells that comes out of it, and a rover goes at an even speed however much it
 * senses on its way.
 */
export class Pace {
  readonly #tape: TapeColumns
  readonly #moveWeight: number
  readonly #searchWeight: number
  #time = 0
  #done = 0

  constructor(tape: TapeColumns) {
    this.#tape = tape
    let moves = 0
    let searches = 0
    for (let i = 0; i < tape.length; i++) {
      if (isMove(tape.kinds[i])) moves++
      else if (isSearch(tape.kinds[i])) searches++
    }
    const searchShare = searches === 0 ? 0 : moves === 0 ? 1 : SEARCH_SHARE
    this.#searchWeight = searchShare / Math.max(1, searches)
    this.#moveWeight = (1 - searchShare) / Math.max(1, moves)
  }

  /** How many events have happened when `share` of the time is over. Asked with rising shares only. */
  timeAt(share: number): number {
    const { kinds, length } = this.#tape
    if (share >= 1) this.#time = length
    while (this.#time < length && this.#done < share) {
      const kind = kinds[this.#time]
      if (isMove(kind)) this.#done += this.#moveWeight
      else if (isSearch(kind)) this.#done += this.#searchWeight
      this.#time++
    }
    return this.#time
  }
}
