import { type Cell, rowOf } from '../grid/grid'
import { costAcross } from '../grid/simplest-path'
import type { ChoiceParam } from './params'

export type Cost = 'cells' | 'euclidean'

/** The parameter of all planners that search a graph. */
export const costParam = {
  name: 'cost',
  label: 'Cost',
  kind: 'choice',
  choices: ['cells', 'euclidean'],
  default: 'cells',
  help: 'cells: every step costs 1 (Chebyshev), and Euclidean length decides between equal paths; euclidean: a diagonal step costs √2 (octile).',
} as const satisfies ChoiceParam<'cost', Cost>

/**
 * What a diagonal step weighs, a straight one being 1. With `cells` it is a trifle more than 1, so
 * that equal paths are told apart by Euclidean length and look straight.
 *
 * Both are multiples of 2^-30. So weights of paths on any map are sums without rounding, and the same
 * steps in another order weigh the same. This √2 is 10^-11 too large: it would take two paths that
 * differ by more than 100,000 diagonal steps to be taken in by that.
 */
export const DIAGONAL_WEIGHT: Record<Cost, number> = {
  cells: 1 + 2 ** -23,
  euclidean: Math.round(Math.SQRT2 * 2 ** 30) / 2 ** 30,
}

/** The cost of a path of that weight. */
export function costOfWeight(cost: Cost, weight: number): number {
  return cost === 'cells' ? Math.floor(weight) : weight
}

/** The cost of a diagonal step, as the costs of paths are summed up: a straight one costs 1. */
export function diagonalCost(cost: Cost): number {
  return costOfWeight(cost, DIAGONAL_WEIGHT[cost])
}

/**
 * Weighs the simplest path to one cell from any other of a map `width` cells wide. No path weighs
 * less, whatever the obstacles. For inner loops: the one cell's place is reckoned once, and nothing
 * is divided.
 */
export function weightsTo(goal: Cell, cost: Cost, width: number): (cell: Cell) => number {
  const more = DIAGONAL_WEIGHT[cost] - 1
  const x = goal % width
  const y = Math.floor(goal / width)
  const share = 1 / width
  return (cell) => {
    const row = rowOf(cell, share)
    const across = Math.abs(cell - row * width - x)
    const down = Math.abs(row - y)
    return costAcross(across, down, more)
  }
}
