import type { Frame } from '../trace/frame'
import { Player } from '../trace/player'
import { Pace } from './pacing'
import type { Shown } from './state'

export interface PlaybackSettings {
  /** From the first to the last event, in milliseconds. */
  readonly duration: number
  /** How often it is played; after each time the end stays for `pause` milliseconds. */
  readonly times: number
  readonly pause: number
}

/** A plan on its way from the first to the last event of its tape. */
export class Playback {
  readonly #shown: Shown
  readonly #settings: PlaybackSettings
  #player: Player
  #pace: Pace
  #began: number | null = null
  #round = 0

  constructor(shown: Shown, settings: PlaybackSettings) {
    this.#shown = shown
    this.#settings = settings
    this.#player = new Player(shown.tape)
    this.#pace = new Pace(shown.tape)
  }

  /**
   * The picture at the moment `now`, in milliseconds; time starts with the first call. `null` when
   * all is over.
   */
  frameAt(now: number): Frame | null {
    const { duration, pause, times } = this.#settings
    this.#began ??= now
    const elapsed = now - this.#began
    const round = Math.floor(elapsed / (duration + pause))
    const inRound = elapsed - round * (duration + pause)
    if (round >= times || (round === times - 1 && inRound >= duration)) return null
    if (round !== this.#round) {
      this.#round = round
      this.#player = new Player(this.#shown.tape)
      this.#pace = new Pace(this.#shown.tape)
    }
    return this.#player.moveTo(this.#pace.timeAt(inRound / duration))
  }
}
