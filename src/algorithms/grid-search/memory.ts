import { Bucket } from './bucket'
import { OpenCells } from './open-cells'

/** What a search knows of a cell: one of these two, with the direction of the step that led to it. */
export const OPEN = 16
export const CLOSED = 32
/** The direction in a state. */
export const DIRECTION = 15

/** Working memory of a search over cells. */
export interface Memory {
  /** 0 for a cell that was not reached yet. */
  readonly states: Uint8Array
  /** Weight of the best path known to each cell that was reached; anything for the others. */
  readonly weights: Float64Array
  /** The same memory for weights that are whole numbers. */
  readonly wholeWeights: Int32Array
  /** Empty ones. */
  readonly buckets: readonly [Bucket, Bucket, Bucket]
}

/** For any search, which is to begin with it: no two go on at the same time. */
export const openCells = new OpenCells()

/** Up to so many cells the memory is kept for the next search. */
const KEPT_CELLS = 1 << 20

let kept: Memory | null = null

/**
 * Memory for a search over so many cells, none of them reached. It belongs to the search until the
 * next one begins.
 */
export function memoryFor(cells: number): Memory {
  if (kept === null || kept.states.length < cells) {
    const memory = newMemory(cells)
    if (cells <= KEPT_CELLS) kept = memory
    return memory
  }
  kept.states.fill(0, 0, cells)
  for (const bucket of kept.buckets) bucket.count = 0
  return kept
}

function newMemory(cells: number): Memory {
  const weights = new Float64Array(cells)
  return {
    states: new Uint8Array(cells),
    weights,
    wholeWeights: new Int32Array(weights.buffer),
    buckets: [new Bucket(), new Bucket(), new Bucket()],
  }
}
