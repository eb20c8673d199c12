import { EVENT } from './events'
import { kindTable } from './kind-table'

/** What a tape leaves out: nothing; small events everywhere; small events, and all that came late. */
export type Thinning = 'whole' | 'thinned' | 'cut'

/** Events without which the others can still be followed. */
const SMALL = [
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
]

/** Also a tape that was cut says how the run ended. */
const ALL_BUT_THE_END = Object.values(EVENT).filter((kind) => kind !== EVENT.end)

/** By kind whether an event is left out. */
export const LEFT_OUT: Record<Thinning, Uint8Array> = {
  whole: kindTable([]),
  thinned: kindTable(SMALL),
  cut: kindTable(ALL_BUT_THE_END),
}
