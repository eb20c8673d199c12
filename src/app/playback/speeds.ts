import { plural } from '../../grid/plural'

/** Steps a second, or the whole tape in a moment. */
export const SPEEDS = [1, 2, 5, 10, 30, 100, 'moment'] as const
export type Speed = (typeof SPEEDS)[number]

/** How a tape is played. */
export type Tempo =
  | { readonly kind: 'steps'; readonly perSecond: number }
  | {
      readonly kind: 'whole'
      /** From the first to the last event, in milliseconds. */
      readonly duration: number
      /** How often it is played; in between the end stays for `pause` milliseconds. */
      readonly times: number
      readonly pause: number
      /** Whether someone asked for it, and so is told of its end. */
      readonly asked: boolean
    }

/** How a new plan is shown. */
export const WELCOME: Tempo = { kind: 'whole', duration: 1000, times: 1, pause: 0, asked: false }

/** For newcomers: slow enough to see what is going on, and more than once. */
export const SHOWCASE: Tempo = {
  kind: 'whole',
  duration: 4500,
  times: 3,
  pause: 1500,
  asked: false,
}

export function tempoOf(speed: Speed): Tempo {
  return speed === 'moment'
    ? { kind: 'whole', duration: 1000, times: 1, pause: 0, asked: true }
    : { kind: 'steps', perSecond: speed }
}

/** Above this, in steps a second, one neither reads nor hears each step. */
const READABLE = 5

/** Whether it goes too fast for words. */
export const isFast = (tempo: Tempo | null): boolean =>
  tempo !== null && (tempo.kind === 'whole' || tempo.perSecond > READABLE)

export const speedInWords = (speed: Speed): string =>
  speed === 'moment' ? 'Whole in a moment' : `${speed} ${plural(speed, 'step')}/s`
