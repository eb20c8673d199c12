import type { Frame } from '../trace/frame'
import { Player } from '../trace/player'
import { type Shown, type State, visiblePlan } from './state'

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
    if (this.#player?.tape !== shown.tape) this.#player = new Player(shown.tape, shown.checkpoints)
    return { shown, frame: this.#player.moveTo(state.time) }
  }
}
