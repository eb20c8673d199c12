import { advance, type Frame, firstFrame } from './frame'
import type { TapeColumns } from './tape'

/** A cursor on a tape with the frame that belongs to it. Forwards it adds, backwards it folds anew. */
export class Player {
  readonly tape: TapeColumns
  private current: Frame

  constructor(tape: TapeColumns) {
    this.tape = tape
    this.current = firstFrame(tape)
  }

  get frame(): Frame {
    return this.current
  }

  /** Moves to the moment after the first `time` events, clamped to the tape. */
  moveTo(time: number): Frame {
    const to = Math.max(0, Math.min(time, this.tape.length))
    if (to < this.current.time) this.current = firstFrame(this.tape)
    advance(this.current, this.tape, to)
    return this.current
  }
}
