import { InputError } from '../grid/errors'
import { advance } from './fold'
import { copyOf, type Frame, firstFrame } from './frame'
import type { Tape } from './tape'

/** So many events are folded within a fraction of an animation frame. */
const REACH = 1 << 16

/**
 * A cursor on a tape with the frame that belongs to it. To move, it folds on from the nearest frame
 * before the new moment. That is its own frame; or one that it keeps some way before the cursor, so
 * that many steps back, one after the other, fold little each; or one of the checkpoints, so that no
 * jump folds all of a long tape.
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

  /**
   * Moves to the moment after the first `time` events, clamped to the tape.
   * @throws InputError if `time` is not a whole number
   */
  moveTo(time: number): Frame {
    if (Math.floor(time) !== time) throw new InputError(`The moment ${time} is not a whole number.`)
    this.approach(time, () => false)
    return this.#current
  }

  /**
   * Moves towards that moment until it is reached or the time is up, but some way in any case. Returns
   * whether it is reached; until then, `frame` is not one to be shown.
   */
  approach(time: number, isTimeUp: () => boolean): boolean {
    const to = Math.max(0, Math.min(time, this.tape.length))
    const checkpoint = this.#checkpointBefore(to)
    if (to < this.#current.time) {
      const before = this.#frameBefore(to, checkpoint, isTimeUp)
      if (!before) return false
      this.#current = before
    } else if (checkpoint && checkpoint.time > this.#current.time) {
      this.#current = copyOf(checkpoint)
    }
    return this.#fold(this.#current, to, isTimeUp)
  }

  /** Returns whether the frame is at that time now. */
  #fold(frame: Frame, time: number, isTimeUp: () => boolean): boolean {
    while (frame.time < time) {
      advance(frame, this.tape, Math.min(time, frame.time + this.#reach))
      if (isTimeUp()) break
    }
    return frame.time >= time
  }

  #checkpointBefore(time: number): Frame | undefined {
    return this.#checkpoints.findLast((frame) => frame.time <= time)
  }

  /** A new frame that is not after `time`, and not far before it; `null` if it takes longer. */
  #frameBefore(time: number, checkpoint: Frame | undefined, isTimeUp: () => boolean): Frame | null {
    const newFrame = () => (checkpoint ? copyOf(checkpoint) : firstFrame(this.tape))
    const from = checkpoint?.time ?? 0
    if (time - from <= this.#reach) return newFrame()
    if (!this.#kept || this.#kept.time > time || this.#kept.time < from) this.#kept = newFrame()
    const isFar = this.#kept.time < time - 2 * this.#reach
    if (isFar && !this.#fold(this.#kept, time - this.#reach, isTimeUp)) return null
    return copyOf(this.#kept)
  }
}
