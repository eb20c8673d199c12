import { advance } from './fold'
import { copyOf, type Frame, firstFrame } from './frame'
import type { Tape } from './tape'

/** So many events are folded within a fraction of an animation frame. */
const REACH = 1 << 16

/**
 * A cursor on a tape with the frame that belongs to it. It folds on from the nearest frame before
 * the moment it is moved to: its own, one that it keeps some way before the cursor, so that one step
 * back of many folds little, or one of the checkpoints, so that no jump folds all of a long tape.
 */
export class Player {
  readonly tape: Tape
  /** Frames of this tape at rising times. */
  readonly #checkpoints: readonly Frame[]
  readonly #reach: number
  #current: Frame
  #kept: Frame | null = null

  /** @param reach how many events before the cursor, at most twice as many, the kept frame lies */
  constructor(tape: Tape, checkpoints: readonly Frame[] = [], reach = REACH) {
    this.tape = tape
    this.#checkpoints = checkpoints
    this.#reach = reach
    this.#current = firstFrame(tape)
  }

  get frame(): Frame {
    return this.#current
  }

  /** Moves to the moment after the first `time` events, clamped to the tape. */
  moveTo(time: number): Frame {
    const to = Math.max(0, Math.min(time, this.tape.length))
    const checkpoint = this.#checkpointBefore(to)
    if (to < this.#current.time) this.#current = this.#frameBefore(to, checkpoint)
    else if (checkpoint && checkpoint.time > this.#current.time) this.#current = copyOf(checkpoint)
    advance(this.#current, this.tape, to)
    return this.#current
  }

  #checkpointBefore(time: number): Frame | undefined {
    return this.#checkpoints.findLast((frame) => frame.time <= time)
  }

  /** A new frame that is not after `time`, and not far before it. */
  #frameBefore(time: number, checkpoint: Frame | undefined): Frame {
    const newFrame = () => (checkpoint ? copyOf(checkpoint) : firstFrame(this.tape))
    const from = checkpoint?.time ?? 0
    if (time - from <= this.#reach) return newFrame()
    if (!this.#kept || this.#kept.time > time || this.#kept.time < from) this.#kept = newFrame()
    if (this.#kept.time < time - 2 * this.#reach) advance(this.#kept, this.tape, time - this.#reach)
    return copyOf(this.#kept)
  }
}
