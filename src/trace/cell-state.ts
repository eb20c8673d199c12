/** What the search knows of a cell. */
export const SEARCH = { untouched: 0, open: 1, closed: 2 } as const

/** What the rover knows of a cell. */
export const KNOWN = { unknown: 0, free: 1, obstacle: 2 } as const

/**
 * All that search and rover know of a cell, in one byte, because a large map has millions of cells:
 * one of SEARCH in two bits, one of KNOWN in the next two, and one bit for whether the rover felt the
 * obstacle that is there.
 */
export type CellState = number

/** Every state is less. */
export const CELL_STATES = 1 << 5

const SEARCH_BITS = 0b11
const KNOWN_SHIFT = 2
const KNOWN_BITS = 0b11 << KNOWN_SHIFT
const FELT_BIT = 1 << 4

/** One of SEARCH. */
export const searchIn = (state: CellState): number => state & SEARCH_BITS

/** One of KNOWN. */
export const knownIn = (state: CellState): number => (state & KNOWN_BITS) >> KNOWN_SHIFT

export const isFeltIn = (state: CellState): boolean => (state & FELT_BIT) !== 0

export const withSearch = (state: CellState, search: number): CellState =>
  (state & ~SEARCH_BITS) | search

export const withKnown = (state: CellState, known: number): CellState =>
  (state & ~KNOWN_BITS) | (known << KNOWN_SHIFT)

export const withFelt = (state: CellState): CellState => state | FELT_BIT
