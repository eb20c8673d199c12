import type { Cell } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import type { Cost } from '../costs'
import { ClearTable } from './clear-table'
import { type Edges, type Rays, raysOver, roomForEdges, type Seen } from './rays'
import { Walker } from './walker'

/** Once so many steps were walked for each cell of the map, it is cheaper to fill a table: measured. */
const WALKED_BEFORE_TABLE = 16

/**
 * What can be seen of the other vertices from a vertex: those to or from which the simplest path is
 * free.
 *
 * All cells with such a path lie on rays that bend once, so that looking along these rays finds them
 * in time that grows with what is seen, not with the number of vertices. Where the map is so wide and
 * empty that it takes long to walk the rays, a table makes a single step of each. Both find the same
 * in the same order, so that it does not show which one it was.
 */
export class Sight {
  /** What `nearest` found last. */
  readonly edges: Edges
  readonly #rays: Rays
  readonly #walker: Walker
  #table: ClearTable | undefined

  /** @param isVertex 1 for each cell of the map that is a vertex. */
  constructor(problem: Problem, isVertex: Uint8Array, cost: Cost) {
    const { width, height } = problem.grid
    this.edges = roomForEdges(Math.max(width, height))
    this.#rays = raysOver(problem, isVertex, cost)
    this.#walker = new Walker(this.#rays, this.edges)
  }

  /**
   * Finds the edges to vertices to which the way is free and leads over no third vertex, writes them
   * into `edges` and returns their number. What is left out changes no shortest path: both parts of
   * such a way are simplest paths too, and together they weigh the same.
   */
  nearest(from: Cell): number {
    return this.isWalking ? this.#walker.nearest(from) : this.#clearTable().nearest(from)
  }

  /** Whether the rays are still walked, and not looked up. */
  get isWalking(): boolean {
    return this.#walker.walked <= WALKED_BEFORE_TABLE * this.#rays.marks.length
  }

  /** Calls `seen` for each vertex to which the way is free, maybe twice: once for each way round. */
  all(from: Cell, seen: Seen): void {
    if (this.isWalking) this.#walker.all(from, seen)
    else this.#clearTable().all(from, seen)
  }

  #clearTable(): ClearTable {
    this.#table ??= new ClearTable(this.#rays, this.edges)
    return this.#table
  }
}
