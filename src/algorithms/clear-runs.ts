import { directionOf, stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import type { Problem } from '../grid/problem'

/** Directions whose cells come later in the map; the opposite ones are asked from the other end. */
const ONWARD = [2, 3, 4, 5] as const

/**
 * How many legal steps lead from each cell in each direction: with that, whether a simplest path
 * is free is two look-ups, however long it is. Filled in one pass over the map.
 */
export class ClearRuns {
  readonly #width: number
  readonly #offsets: Int32Array
  readonly #runs: readonly Uint16Array[]

  constructor({ grid, diagonal }: Problem) {
    const legal = allLegalSteps(grid, diagonal)
    this.#width = grid.width
    this.#offsets = stepOffsets(grid.width)
    this.#runs = ONWARD.map((direction) => runsIn(direction, this.#offsets[direction], legal))
  }

  /** Whether every step of the simplest path from `from` to `to` is legal. */
  isFree(from: Cell, to: Cell): boolean {
    const width = this.#width
    const dx = (to % width) - (from % width)
    const dy = Math.floor(to / width) - Math.floor(from / width)
    const across = Math.abs(dx)
    const down = Math.abs(dy)
    const diagonals = Math.min(across, down)
    let bend = from
    if (diagonals > 0) {
      const direction = directionOf(dx, dy)
      bend = from + diagonals * this.#offsets[direction]
      if (!this.#isClear(from, bend, direction, diagonals)) return false
    }
    const straights = Math.max(across, down) - diagonals
    if (straights === 0) return true
    const direction = across > down ? directionOf(dx, 0) : directionOf(0, dy)
    return this.#isClear(bend, to, direction, straights)
  }

  #isClear(from: Cell, to: Cell, direction: number, steps: number): boolean {
    const onward = direction >= 2 && direction <= 5
    const runs = this.#runs[onward ? direction - 2 : (direction ^ 4) - 2]
    return runs[onward ? from : to] >= steps
  }
}

function runsIn(direction: number, offset: number, legal: Uint8Array): Uint16Array {
  const runs = new Uint16Array(legal.length)
  for (let cell = legal.length - 1; cell >= 0; cell--) {
    if ((legal[cell] >> direction) & 1) runs[cell] = runs[cell + offset] + 1
  }
  return runs
}
