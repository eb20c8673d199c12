import type { Cell, Grid } from '../../../src/grid/grid'
import type { Query } from '../maps'

/** The cells of a path from start to goal; empty if none was found. */
type Find = (start: Cell, goal: Cell) => readonly Cell[]

/** A path finder from elsewhere, set to `only-when-no-obstacles` and steps of 1 and √2. */
export interface Peer {
  readonly name: string
  /**
   * What it keeps between the queries on one map is made here, and not counted; what each query
   * needs anew, such as a grid that serves one query only, is made in `Find`, and counted.
   */
  readonly on: (grid: Grid) => Find
}

/** A peer that can be asked about any map. What it keeps of one is made with the first query on it. */
export function onAnyMap(peer: Peer): (grid: Grid, query: Query) => readonly Cell[] {
  const finds = new Map<Grid, Find>()
  return (grid, { start, goal }) => {
    const find = finds.get(grid) ?? peer.on(grid)
    finds.set(grid, find)
    return find(start, goal)
  }
}
