// How a tape lies in memory. Apart from it, so that the bundler puts the numbers where they are used:
// a tape is written in inner loops.

/** Events are kept in chunks of so many, so that nothing is copied when a tape grows. */
export const CHUNK_BITS = 12
export const CHUNK = 1 << CHUNK_BITS
/** But the first one has room for so many at first: tapes of small maps are short, and many. */
export const FIRST_ROOM = 1 << 10
/** The place of an event in its chunk. */
export const PLACE = CHUNK - 1

/**
 * An event has two words. In the first one are its cell and its kind, in the second one its other
 * number and its line, each number of up to 23 bits above eight bits. Values have chunks of their own,
 * and where all are 0 there is none: searches over cells, the longest tapes of all, need no values.
 */
export const EVENT_WORDS = 2
