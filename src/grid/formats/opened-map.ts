import { defaultEnds } from '../ends'
import { cellName, type Grid } from '../grid'
import type { Problem } from '../problem'
import type { DiagonalRule } from '../steps'

/** A problem read from a file, and sentences about what the file left open. */
export interface OpenedMap {
  readonly problem: Problem
  readonly notes: readonly string[]
}

/**
 * A map from a file without start and goal: they are put left and right.
 * @throws InputError if no cell is free.
 */
export function openedWithoutEnds(grid: Grid, diagonal: DiagonalRule): OpenedMap {
  const { start, goal } = defaultEnds(grid)
  const places = `${cellName(grid.width, start)} and ${cellName(grid.width, goal)}`
  return {
    problem: { grid, start, goal, diagonal },
    notes: [`The file has no start or goal: they were put at ${places}.`],
  }
}
