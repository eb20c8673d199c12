import type { Direction } from '../grid/directions'

/** What the search knows of a cell. */
export const SEARCH = { untouched: 0, open: 1, closed: 2 } as const

/** What the rover knows of a cell. */
export const KNOWN = { unknown: 0, free: 1, obstacle: 2 } as const

/**
 * All that search and rover know of a cell, in one byte, because a large map has millions of cells:
 * one of SEARCH in two bits, one of KNOWN in the next two, one bit for whether the rover felt the
 * obstacle that is there, and in the last three the direction of the step by which a search over cells
 * came there.
 */
export type CellState = number

/** Every state is less. */
export const CELL_STATES = 1 << 8

const SEARCH_BITS = 0b11
const KNOWN_SHIFT = 2
const KNOWN_BITS = 0b11 << KNOWN_SHIFT
const FELT_BIT = 1 << 4
const ARRIVAL_SHIFT = 5
const ARRIVAL_BITS = 0b111 << ARRIVAL_SHIFT

/** One of SEARCH. */
export const searchIn = (state: CellState): number => state & SEARCH_BITS

/** One of KNOWN. */
export const knownIn = (state: CellState): number => (state & KNOWN_BITS) >> KNOWN_SHIFT

export const isFeltIn = (state: CellState): boolean => (state & FELT_BIT) !== 0

/** Of a cell to which no step led it is any. */
export const arrivalIn = (state: CellState): Direction => state >> ARRIVAL_SHIFT

export const withSearch = (state: CellState, search: number): CellState =>
  (state & ~SEARCH_BITS) | search

export const withKnown = (state: CellState, known: number): CellState =>
  (state & ~KNOWN_BITS) | (known << KNOWN_SHIFT)

export const withFelt = (state: CellState): CellState => state | FELT_BIT

export const withArrival = (state: CellState, direction: Direction): CellState =>
  (state & ~ARRIVAL_BITS) | (direction << ARRIVAL_SHIFT)
