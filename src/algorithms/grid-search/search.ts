import type { Problem } from '../../grid/problem'
import type { Tape } from '../../trace/tape'
import type { Cost } from '../costs'

/** A search for a path of least cost over the cells of a map. */
export type CellSearch = (task: SearchTask) => Found

export interface SearchTask {
  readonly problem: Problem
  /** The legal steps from every cell of its map. */
  readonly legal: Uint8Array
  readonly cost: Cost
  readonly tape: Tape | undefined
  /** Lines of the pseudocode: the start is opened, a cell is closed, a jump point is opened. */
  readonly lines: { readonly start: number; readonly close: number; readonly jump: number }
  readonly progress: (done: number) => void
}

export interface Found {
  /** From start to goal; empty if there is no path. */
  readonly path: Int32Array
  /** Cells whose shortest path became final. */
  readonly expanded: number
}

/** How many cells are expanded between two reports of progress. */
export const PROGRESS_EVERY = 1 << 16
