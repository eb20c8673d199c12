import type { Direction } from '../../../grid/directions'
import { larger } from '../../../grid/larger'
import type { View } from './views'

const ROOM = 1 << 10

export interface Edge {
  /** The vertex to which it leads. */
  readonly end: number
  /** Directions of its first and its last step. */
  readonly departure: Direction
  readonly arrival: Direction
  readonly weight: number
  /** What jumps looked at on it. */
  readonly view: View
}

/** The edges of a graph of jumps, numbered as they come. Those from one vertex make a chain. */
export class Edges {
  #count = 0
  /** `vertex where it ends << 6 | direction of the first step << 3 | direction of the last step` */
  #ends = new Int32Array(ROOM)
  #weights = new Float64Array(ROOM)
  #views = new Int32Array(ROOM)
  #next = new Int32Array(ROOM)

  /**
   * Puts an edge into the chain that begins with edge `first` (-1: none), which is in the order of
   * departures, so that searches do the same however the edges came; returns where it begins now.
   */
  add(first: number, { end, departure, arrival, weight, view }: Edge): number {
    const edge = this.#count++
    if (edge === this.#ends.length) this.#grow()
    this.#ends[edge] = (end << 6) | (departure << 3) | arrival
    this.#weights[edge] = weight
    this.#views[edge] = view
    let before = -1
    let next = first
    while (next >= 0 && this.departure(next) < departure) {
      before = next
      next = this.#next[next]
    }
    this.#next[edge] = next
    if (before < 0) return edge
    this.#next[before] = edge
    return first
  }

  next(edge: number): number {
    return this.#next[edge]
  }

  end(edge: number): number {
    return this.#ends[edge] >> 6
  }

  departure(edge: number): Direction {
    return (this.#ends[edge] >> 3) & 7
  }

  arrival(edge: number): Direction {
    return this.#ends[edge] & 7
  }

  weight(edge: number): number {
    return this.#weights[edge]
  }

  view(edge: number): View {
    return this.#views[edge]
  }

  #grow(): void {
    const room = this.#ends.length + (this.#ends.length >> 1)
    this.#ends = larger(this.#ends, new Int32Array(room))
    this.#weights = larger(this.#weights, new Float64Array(room))
    this.#views = larger(this.#views, new Int32Array(room))
    this.#next = larger(this.#next, new Int32Array(room))
  }
}
