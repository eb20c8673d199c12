import type { Cell } from '../grid/grid'
import type { ChoiceParam } from './params'

export type Cost = 'cells' | 'euclidean'

/** The parameter of all planners that search a graph. */
export const costParam = {
  name: 'cost',
  label: 'Cost',
  kind: 'choice',
  choices: ['cells', 'euclidean'],
  default: 'cells',
  help: 'cells: every step costs 1 (Chebyshev); euclidean: a diagonal step costs √2 (octile).',
} as const satisfies ChoiceParam<'cost', Cost>

const MORE_THAN_ANY_PATH = 2 ** 23

/**
 * One number that orders ways of `steps` steps, `diagonals` of them diagonal: by their cost, and
 * with `cells` by Euclidean length among equals, so that paths look straight. Sums of ranks are
 * ranks of sums.
 */
export function rank(cost: Cost, steps: number, diagonals: number): number {
  return cost === 'cells'
    ? steps * MORE_THAN_ANY_PATH + diagonals
    : steps - diagonals + diagonals * Math.SQRT2
}

/** The cost that a rank stands for. */
export function costOfRank(cost: Cost, rank: number): number {
  return cost === 'cells' ? Math.floor(rank / MORE_THAN_ANY_PATH) : rank
}

/** Ranks the simplest path between two cells of a map `width` cells wide. */
export function simplestPathRanks(cost: Cost, width: number): (a: Cell, b: Cell) => number {
  return (a, b) => {
    const aboveA = Math.floor(a / width)
    const aboveB = Math.floor(b / width)
    const across = Math.abs(a - aboveA * width - (b - aboveB * width))
    const down = Math.abs(aboveA - aboveB)
    return across > down ? rank(cost, across, down) : rank(cost, down, across)
  }
}
