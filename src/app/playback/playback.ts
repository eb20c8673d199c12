import type { Tape } from '../../trace/tape'
import { Pace } from './pacing'
import type { Tempo } from './speeds'
import { stepAt, timelineOf } from './timeline'

/** What is being played: `time` events of the tape have happened so far. */
export interface Played {
  readonly tape: Tape
  readonly tempo: Tempo
  readonly time: number
}

/** In one call, which is one frame: a long tape takes more of them rather than longer ones. */
const MOST_EVENTS = 1 << 17

/** A tape on its way to its end. Knows no clock: it is told what time it is. */
export class Playback {
  readonly #tape: Tape
  readonly #tempo: Tempo
  readonly #timeAfter: (elapsed: number) => number
  #began: number | null = null
  #time: number

  constructor({ tape, tempo, time }: Played) {
    this.#tape = tape
    this.#tempo = tempo
    this.#time = time
    this.#timeAfter =
      tempo.kind === 'steps' ? bySteps(tape, time, tempo.perSecond) : whole(tape, time, tempo)
  }

  /** Whether it is this that is being played, and nobody moved it meanwhile. */
  isPlaying({ tape, tempo, time }: Played): boolean {
    return tape === this.#tape && tempo === this.#tempo && time === this.#time
  }

  /**
   * How many events have happened at the moment `now`, in milliseconds; it begins with the first
   * call. Infinity when all is over.
   */
  timeAt(now: number): number {
    this.#began ??= now
    const due = this.#timeAfter(now - this.#began)
    const most = this.#time + MOST_EVENTS
    this.#time = Math.min(due, this.#tape.length) > most ? most : due
    return this.#time
  }
}

/** The first step is taken at once: whoever presses play sees that it plays. */
function bySteps(tape: Tape, from: number, perSecond: number): (elapsed: number) => number {
  const timeline = timelineOf(tape)
  const first = stepAt(timeline, from) + 1
  const last = timeline.steps.length - 1
  return (elapsed) => {
    const step = first + Math.floor((elapsed * perSecond) / 1000)
    return step < last ? timeline.steps[step] : Number.POSITIVE_INFINITY
  }
}

function whole(
  tape: Tape,
  from: number,
  { duration, times, pause }: Extract<Tempo, { kind: 'whole' }>,
): (elapsed: number) => number {
  let pace = new Pace(tape)
  const begun = duration * pace.beginAt(from)
  let round = 0
  return (elapsed) => {
    const all = begun + elapsed
    const now = Math.floor(all / (duration + pause))
    const inRound = all - now * (duration + pause)
    if (now >= times || (now === times - 1 && inRound >= duration)) return Number.POSITIVE_INFINITY
    if (now !== round) {
      round = now
      pace = new Pace(tape)
    }
    return pace.timeAt(inRound / duration)
  }
}
