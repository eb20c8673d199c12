import type { Problem } from '../problem'

/** A problem read from a file, and sentences about what the file left open. */
export interface OpenedMap {
  readonly problem: Problem
  readonly notes: readonly string[]
}
