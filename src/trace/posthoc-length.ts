import { EVENT, type EventKind } from './events'
import type { Tape } from './tape'

/** For the kinds of events that long tapes are made of, how many characters each comes to at least. */
const LEAST: readonly (readonly [EventKind, number])[] = [
  [EVENT.test, 50],
  [EVENT.vertex, 50],
  [EVENT.edge, 75],
  // A cell is expanded, and later closed.
  [EVENT.close, 110],
  [EVENT.attraction, 60],
  [EVENT.repulsion, 60],
  [EVENT.potential, 60],
]

const LEAST_OF_KIND = new Uint8Array(256)
for (const [kind, least] of LEAST) LEAST_OF_KIND[kind] = least

/** So many are looked at within a fraction of a frame. */
const EVENTS_AT_ONCE = 1 << 17

/** A number of characters that the events of a tape's trace have at least. */
export function* leastLength(tape: Tape): Generator<string, number, void> {
  let length = 0
  for (let i = 0; i < tape.length; i++) {
    length += LEAST_OF_KIND[tape.kind(i)]
    if (i % EVENTS_AT_ONCE === 0) yield ''
  }
  return length
}
