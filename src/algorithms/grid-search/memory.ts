import { Bucket } from './bucket'
import { OpenCells } from './open-cells'

/**
 * What a search knows of a cell, in one number, because a large map's other numbers are far away: its
 * legal steps, eight bits; the direction of the step that led to it, four bits; and these two.
 */
export const OPEN = 1 << 12
export const CLOSED = 1 << 13
export const LEGAL = 255
export const DIRECTION_SHIFT = 8
export const DIRECTION = 15 << DIRECTION_SHIFT
/** Direction and legal steps: where its successors stand in their table. */
export const STEPS = 0xfff

/** The direction in a state. */
export const directionIn = (state: number): number => (state & DIRECTION) >> DIRECTION_SHIFT

/**
 * A unit of weight, where weights are whole numbers, modulo 2^32: those of cells that wait differ by
 * less than three units, so their difference still tells which one is less, and half as much memory
 * goes through the processor.
 */
export const UNIT = 1 << 29

/** Working memory of a search over cells. What is in it is of the search before. */
export interface Memory {
  readonly states: Uint16Array
  /** Weight of the best path known to each cell that was reached; anything for the others. */
  readonly weights: Float64Array
  /** The same memory for weights in whole numbers, see UNIT. */
  readonly wholeWeights: Int32Array
  /** Empty ones. */
  readonly buckets: readonly [Bucket, Bucket, Bucket]
}

/** For any search, which is to begin with it: no two go on at the same time. */
export const openCells = new OpenCells()

/** Up to so many cells the memory is kept for the next search. */
const KEPT_CELLS = 1 << 20

let kept: Memory | null = null

/** Memory for a search over so many cells. It belongs to the search until the next one begins. */
export function memoryFor(cells: number): Memory {
  if (kept === null || kept.states.length < cells) {
    const memory = newMemory(cells)
    if (cells <= KEPT_CELLS) kept = memory
    return memory
  }
  for (const bucket of kept.buckets) bucket.count = 0
  return kept
}

function newMemory(cells: number): Memory {
  const weights = new Float64Array(cells)
  return {
    states: new Uint16Array(cells),
    weights,
    wholeWeights: new Int32Array(weights.buffer),
    buckets: [new Bucket(), new Bucket(), new Bucket()],
  }
}
