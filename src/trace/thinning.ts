import { EVENT } from './events'

/** What a long tape leaves out: nothing; small events, all along; these, and what came at its end. */
export type Thinning = 'whole' | 'thinned' | 'cut'

/** Events without which the others can be followed. */
const SMALL: ReadonlySet<number> = new Set([
  EVENT.row,
  EVENT.test,
  EVENT.refuse,
  EVENT.open,
  EVENT.attraction,
  EVENT.repulsion,
  EVENT.sense,
  EVENT.target,
  EVENT.turn,
  EVENT.feel,
  EVENT.scan,
  EVENT.node,
  EVENT.value,
])

const ALL = new Set<number>(Object.values(EVENT))
/** That it was cut is no reason not to say how it ended. */
const ALL_BUT_THE_END = new Set([...ALL].filter((kind) => kind !== EVENT.end))

const marked = (kinds: ReadonlySet<number>): Uint8Array =>
  Uint8Array.from({ length: ALL.size }, (_, kind) => (kinds.has(kind) ? 1 : 0))

/** By kind whether an event is left out. */
export const LEFT_OUT: Record<Thinning, Uint8Array> = {
  whole: marked(new Set()),
  thinned: marked(SMALL),
  cut: marked(ALL_BUT_THE_END),
}
