import type { Direction } from '../../../grid/directions'
import type { Cell } from '../../../grid/grid'
import { larger } from '../../../grid/larger'
import type { Directions } from '../../../grid/steps'

const ROOM = 1 << 10

/** The vertices of a graph of jumps, numbered as they come; by number what is known of them. */
export class Vertices {
  count = 0

  // What holds on the map, whatever the goal.
  /** Directions: a jump was tried; it leads somewhere; it was followed to where there is a choice. */
  tried = new Uint8Array(ROOM)
  leading = new Uint8Array(ROOM)
  followed = new Uint8Array(ROOM)
  /** What the jumps that were tried looked at, and all on the ways followed. */
  views = new Int32Array(ROOM)
  farViews = new Int32Array(ROOM)
  /** The first of the edges from here, counted from 1; 0 if there is none. */
  edges = new Int32Array(ROOM)
  /** `cell << 8 | legal steps` */
  #places = new Int32Array(ROOM)

  // What the search at hand knows, as of cells. The states are to be cleared before the next one.
  states = new Uint16Array(ROOM)
  weights = new Float64Array(ROOM)
  /** The vertex before on its best path, and the direction in which it leaves there. */
  #parents = new Int32Array(ROOM)

  add(cell: Cell, legal: Directions): number {
    const vertex = this.count++
    if (vertex === this.states.length) this.#grow()
    this.#places[vertex] = (cell << 8) | legal
    return vertex
  }

  cell(vertex: number): Cell {
    return this.#places[vertex] >> 8
  }

  legal(vertex: number): Directions {
    return this.#places[vertex] & 255
  }

  parent(vertex: number): number {
    return this.#parents[vertex] >> 3
  }

  departure(vertex: number): Direction {
    return this.#parents[vertex] & 7
  }

  setParent(vertex: number, parent: number, departure: Direction): void {
    this.#parents[vertex] = (parent << 3) | departure
  }

  #grow(): void {
    const room = this.states.length + (this.states.length >> 1)
    this.tried = larger(this.tried, new Uint8Array(room))
    this.leading = larger(this.leading, new Uint8Array(room))
    this.followed = larger(this.followed, new Uint8Array(room))
    this.views = larger(this.views, new Int32Array(room))
    this.farViews = larger(this.farViews, new Int32Array(room))
    this.edges = larger(this.edges, new Int32Array(room))
    this.#places = larger(this.#places, new Int32Array(room))
    this.states = larger(this.states, new Uint16Array(room))
    this.weights = larger(this.weights, new Float64Array(room))
    this.#parents = larger(this.#parents, new Int32Array(room))
  }
}
