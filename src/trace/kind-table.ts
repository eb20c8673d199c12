import type { EventKind } from './events'

/**
 * For each kind of event 1 if it is one of these, else 0. Tapes are long, and looking up a set would
 * take longer than the rest of a loop over one.
 */
export function kindTable(kinds: Iterable<EventKind>): Uint8Array {
  const table = new Uint8Array(256)
  for (const kind of kinds) table[kind] = 1
  return table
}
