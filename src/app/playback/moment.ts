import type { Frame } from '../../trace/frame'
import { Player } from '../../trace/player'
import { type Shown, type State, visiblePlan } from '../state/state'

/** The plan on screen with its picture at the moment at which the cursor stands. */
export interface Moment {
  readonly shown: Shown
  readonly frame: Frame
}

export const isAtEnd = ({ shown, frame }: Moment): boolean => frame.time >= shown.tape.length

/** Finds the moment of a state. One tape has one player, and the end was folded in the worker. */
export class Moments {
  #player: Player | null = null

  of(state: State): Moment | null {
    const shown = visiblePlan(state)
    if (!shown) return null
    if (state.time >= shown.tape.length) return { shown, frame: shown.last }
    return { shown, frame: this.#playerOf(shown).moveTo(state.time) }
  }

  /** Goes on looking for the moment of a state while there is time; returns whether it is found. */
  seek(state: State, isTimeUp: () => boolean): boolean {
    const shown = visiblePlan(state)
    if (!shown || state.time >= shown.tape.length) return true
    return this.#playerOf(shown).approach(state.time, isTimeUp)
  }

  #playerOf({ tape, checkpoints }: Shown): Player {
    if (this.#player?.tape !== tape) this.#player = new Player(tape, checkpoints)
    return this.#player
  }
}
