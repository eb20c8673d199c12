import { type CostName, isShorter, lengthOf, type Way } from './shortest'
import { DIRECTIONS, isLegal, legalNeighbours, type World, type XY } from './world'

/** What a search knows of a cell that it has reached. */
export interface Reached {
  readonly cell: XY
  readonly way: Way
  /** The cell before it; none before the start. */
  readonly before: XY | undefined
  readonly isClosed: boolean
}

/**
 * A search over the cells of a map, from the definition and very slow: it is told which cell to close
 * next, and then knows which cells are open and by which ways.
 */
export class CellSearch {
  readonly reached = new Map<string, Reached>()
  readonly #world: World
  readonly #cost: CostName

  constructor(world: World, cost: CostName) {
    this.#world = world
    this.#cost = cost
    this.#reach(world.start, { steps: 0, diagonals: 0 }, undefined)
  }

  /** Closes an open cell; its neighbours may get shorter ways. */
  close(cell: XY): void {
    const here = this.reached.get(String(cell))
    if (!here || here.isClosed) throw new Error(`${cell} is not open`)
    this.reached.set(String(cell), { ...here, isClosed: true })
    for (const next of legalNeighbours(this.#world, cell)) {
      if (here.before && this.#isAsCheapWithout(here.before, cell, next)) continue
      const way = joined(here.way, stepWay(cell, next))
      const known = this.reached.get(String(next))
      if (known && (known.isClosed || !isShorter(way, known.way, this.#cost))) continue
      this.#reach(next, way, cell)
    }
  }

  #reach(cell: XY, way: Way, before: XY | undefined): void {
    this.reached.set(String(cell), { cell, way, before, isClosed: false })
  }

  /**
   * Whether one comes from `before` to a neighbour of `cell` without it, around it: by less than over
   * it, or after a straight step to it by as much, as the diagonal step shall come first.
   */
  #isAsCheapWithout(before: XY, cell: XY, next: XY): boolean {
    const first = stepWay(before, cell)
    const over = lengthOf(joined(first, stepWay(cell, next)))
    const around = this.#lengthAround(cell, before, next)
    return first.diagonals > 0 ? around < over - 1e-9 : around < over + 1e-9
  }

  /** The length of the shortest way between two neighbours of a cell over others of them. */
  #lengthAround(cell: XY, from: XY, to: XY): number {
    const lengths = new Map([[String(from), 0]])
    const waiting = [from]
    for (const here of waiting) {
      for (const next of neighboursOf(cell)) {
        if (!isLegal(this.#world, here, next)) continue
        const length = (lengths.get(String(here)) ?? 0) + lengthOf(stepWay(here, next))
        if (length >= (lengths.get(String(next)) ?? Number.POSITIVE_INFINITY) - 1e-9) continue
        lengths.set(String(next), length)
        waiting.push(next)
      }
    }
    return lengths.get(String(to)) ?? Number.POSITIVE_INFINITY
  }
}

const neighboursOf = ([x, y]: XY): XY[] => DIRECTIONS.map(([dx, dy]) => [x + dx, y + dy])

const stepWay = (from: XY, to: XY): Way => ({
  steps: 1,
  diagonals: from[0] !== to[0] && from[1] !== to[1] ? 1 : 0,
})

export const joined = (a: Way, b: Way): Way => ({
  steps: a.steps + b.steps,
  diagonals: a.diagonals + b.diagonals,
})
