import { type Direction, stepOffsets } from '../../grid/directions'
import type { Cell } from '../../grid/grid'
import { allLegalSteps } from '../../grid/legal-steps'
import type { Problem } from '../../grid/problem'
import { type Cost, DIAGONAL_WEIGHT } from '../costs'

/** What rays run over. */
export interface Rays {
  /** For each cell its legal steps, and whether it is a `VERTEX`. */
  readonly marks: Uint16Array
  /** What a step in each direction adds to a cell. */
  readonly offsets: Int32Array
  /** What a straight and a diagonal step weigh. */
  readonly weights: readonly [number, number]
}

export const VERTEX = 1 << 8

/** @param isVertex 1 for each cell of the map that is a vertex. */
export function raysOver({ grid, diagonal }: Problem, isVertex: Uint8Array, cost: Cost): Rays {
  const legal = allLegalSteps(grid, diagonal)
  const marks = new Uint16Array(legal.length)
  for (let cell = 0; cell < marks.length; cell++) {
    marks[cell] = legal[cell] | (isVertex[cell] * VERTEX)
  }
  return { marks, offsets: stepOffsets(grid.width), weights: [1, DIAGONAL_WEIGHT[cost]] }
}

/** 1 if a simplest path to a vertex is the free one; 0 if it is the one back from it. */
export type Outward = 0 | 1

/**
 * A simplest path begins with its diagonal part. So a ray that begins diagonally and bends is one,
 * and a ray that begins straight and bends is one walked backwards.
 */
export const outwardAfter = (first: Direction): Outward => (first & 1 ? 1 : 0)

/** Edges of one vertex, in columns. A vertex may stand there twice, once for each way round. */
export interface Edges {
  /** The vertices at their other ends. */
  readonly ends: Int32Array
  readonly weights: Float64Array
  readonly outwards: Uint8Array
}

/** Room for what rays of at most so many steps find: a vertex at the end of each, two at each bend. */
export function roomForEdges(steps: number): Edges {
  const room = 8 * (1 + 2 * steps)
  return {
    ends: new Int32Array(room),
    weights: new Float64Array(room),
    outwards: new Uint8Array(room),
  }
}

export type Seen = (vertex: Cell, outward: Outward) => void
