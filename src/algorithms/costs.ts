import { type Cell, rowOf } from '../grid/grid'
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

/** The weight of the simplest path so far across and down; a diagonal step weighs 1 + `more`. */
function weightOf(across: number, down: number, more: number): number {
  return across > down ? across + more * down : down + more * across
}

/** The cost of a diagonal step, as the costs of paths are summed up: a straight one costs 1. */
export function diagonalCost(cost: Cost): number {
  return costOfWeight(cost, DIAGONAL_WEIGHT[cost])
}

/**
 * Weighs the simplest path between two cells of a map `width` cells wide. No path weighs less,
 * whatever the obstacles.
 */
export function simplestPathWeights(cost: Cost, width: number): (a: Cell, b: Cell) => number {
  const more = DIAGONAL_WEIGHT[cost] - 1
  return (a, b) => {
    const aboveA = Math.floor(a / width)
    const aboveB = Math.floor(b / width)
    const across = Math.abs(a - aboveA * width - (b - aboveB * width))
    const down = Math.abs(aboveA - aboveB)
    return weightOf(across, down, more)
  }
}

/** The same to one cell from many, for inner loops: its place is reckoned once, and nothing divided. */
export function weightsTo(goal: Cell, cost: Cost, width: number): (cell: Cell) => number {
  const more = DIAGONAL_WEIGHT[cost] - 1
  const x = goal % width
  const y = Math.floor(goal / width)
  const share = 1 / width
  return (cell) => {
    const above = rowOf(cell, share)
    const across = Math.abs(cell - above * width - x)
    const down = Math.abs(above - y)
    return weightOf(across, down, more)
  }
}
