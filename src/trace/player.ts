import { advance, copyOf, type Frame, firstFrame } from './frame'
import type { TapeColumns } from './tape'

/** So many events are folded within a fraction of an animation frame. */
const REACH = 1 << 16

/**
 * A cursor on a tape with the frame that belongs to it. Forwards it adds. Backwards it folds anew,
 * on long tapes from a frame that it keeps some way before the cursor, so that one step back of
 * many folds little.
 */
export class Player {
  readonly tape: TapeColumns
  readonly #reach: number
  #current: Frame
  #kept: Frame | null = null

  /** @param reach how many events before the cursor, at most twice as many, the kept frame lies */
  constructor(tape: TapeColumns, reach = REACH) {
    this.tape = tape
    this.#reach = reach
    this.#current = firstFrame(tape)
  }

  get frame(): Frame {
    return this.#current
  }

  /** Moves to the moment after the first `time` events, clamped to the tape. */
  moveTo(time: number): Frame {
    const to = Math.max(0, Math.min(time, this.tape.length))
    if (to < this.#current.time) this.#current = this.#frameBefore(to)
    advance(this.#current, this.tape, to)
    return this.#current
  }

  /** A new frame that is not after `time`, and not far before it. */
  #frameBefore(time: number): Frame {
    if (time <= this.#reach) return firstFrame(this.tape)
    if (!this.#kept || this.#kept.time > time) this.#kept = firstFrame(this.tape)
    if (this.#kept.time < time - 2 * this.#reach) advance(this.#kept, this.tape, time - this.#reach)
    return copyOf(this.#kept)
  }
}
