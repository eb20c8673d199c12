import type { Cell } from '../grid/grid'
import { simplestPathCost } from '../grid/simplest-path'
import type { Tape } from './tape'

/** What a search that estimates reckons is left from a cell to the goal, in the tape's costs. */
export const costLeft = ({ width, diagonalCost }: Tape, cell: Cell, goal: Cell): number =>
  simplestPathCost(cell, goal, width, diagonalCost)
