import type { Direction } from '../../../grid/directions'
import type { Cell } from '../../../grid/grid'
import type { Problem } from '../../../grid/problem'
import type { Directions } from '../../../grid/steps'
import { successorsUnder } from '../successors'
import { Edges } from './edges'
import type { GoalInSight } from './goal-in-sight'
import { Looks } from './looks'
import { Rounds } from './rounds'
import { Vertices } from './vertices'
import { covers, joined, type View } from './views'

/** By the legal steps of their maps. */
const graphs = new WeakMap<Uint8Array, JumpGraph>()

/**
 * The graph of the map of which these are the legal steps. What a search finds out about it is kept
 * for the next one on the same map.
 */
export function jumpGraphOf(
  legal: Uint8Array,
  problem: Problem,
  diagonalWeight: number,
): JumpGraph {
  const known = graphs.get(legal)
  if (known?.diagonalWeight === diagonalWeight) return known
  const graph = new JumpGraph(legal, problem, diagonalWeight)
  graphs.set(legal, graph)
  return graph
}

/**
 * Where jumps lead on a map, whatever the goal. Vertices are the cells to which they led so far; an
 * edge leads from one where a path has a choice to the next one. All is looked for when it is first
 * asked for, and only once.
 */
export class JumpGraph {
  // Of the latest way that was followed, the vertex where it ends (-1 if it leads nowhere), what it
  // weighs, the direction of its last step, and what jumps looked at on it:
  end = -1
  weight = 0
  arrival: Direction = 0
  view: View = 0
  readonly diagonalWeight: number
  readonly vertices = new Vertices()
  readonly edges = new Edges()
  readonly looks: Looks
  readonly #rounds = new Rounds()
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  /** By cell its vertex, counted from 1. */
  readonly #vertexOf: Int32Array

  constructor(legal: Uint8Array, problem: Problem, diagonalWeight: number) {
    this.diagonalWeight = diagonalWeight
    this.looks = new Looks(legal, problem, diagonalWeight)
    this.#legal = legal
    this.#successors = successorsUnder(problem.diagonal)
    this.#vertexOf = new Int32Array(legal.length)
  }

  /** The vertex of a cell; -1 if there is none. */
  vertexAt(cell: Cell): number {
    return this.#vertexOf[cell] - 1
  }

  /** The vertex of a cell, made if there is none. */
  madeAt(cell: Cell): number {
    const known = this.vertexAt(cell)
    if (known >= 0) return known
    const vertex = this.vertices.add(cell, this.#legal[cell])
    this.#vertexOf[cell] = vertex + 1
    return vertex
  }

  /** Where a shortest path may go on from a vertex to which it came in direction `arrival`. */
  ways(vertex: number, arrival: number): Directions {
    return this.#successors[(arrival << 8) | this.vertices.legal(vertex)]
  }

  /** Sees to it that the edges from a vertex in these directions are known. */
  explore(vertex: number, directions: Directions): void {
    const { vertices, edges } = this
    let missing = directions & ~vertices.followed[vertex]
    vertices.followed[vertex] |= missing
    while (missing !== 0) {
      const d = 31 - Math.clz32(missing)
      missing ^= 1 << d
      this.follow(vertex, d, null)
      vertices.farViews[vertex] = joined(vertices.farViews[vertex], this.view)
      if (this.end < 0) continue
      const { end, arrival, weight, view } = this
      const first = vertices.edges[vertex] - 1
      vertices.edges[vertex] = edges.add(first, { end, departure: d, arrival, weight, view }) + 1
    }
  }

  /**
   * Jumps from a vertex, first in a legal direction, until several ways lead on. One is no choice.
   * @param goal to end at, and to look for from each vertex on the way
   */
  follow(vertex: number, departure: Direction, goal: GoalInSight | null): void {
    const { vertices, looks } = this
    let cell = vertices.cell(vertex)
    let d = departure
    this.end = -1
    this.weight = 0
    this.view = 0
    this.#rounds.begin()
    do {
      const end = looks.from(cell, d, goal)
      if (goal === null) this.view = joined(this.view, looks.view)
      if (end < 0) return
      const to = this.madeAt(end)
      this.weight += looks.weight
      this.arrival = looks.arrival
      const isGoal = goal?.isAt(end) ?? false
      const ways = isGoal ? 0 : this.leading(to, this.ways(to, this.arrival), goal)
      if (isGoal || (ways & (ways - 1)) !== 0) {
        this.end = to
        return
      }
      this.view = joined(this.view, vertices.views[to])
      if (ways === 0) return
      cell = end
      d = 31 - Math.clz32(ways)
    } while (!this.#rounds.isBack(cell, d))
  }

  /** As if the way of an edge had been followed. */
  take(edge: number): void {
    const { edges } = this
    this.end = edges.end(edge)
    this.arrival = edges.arrival(edge)
    this.weight = edges.weight(edge)
  }

  /**
   * Those of the ways from a vertex that lead to a jump point; some of them if there are several.
   * @param goal that counts as one, as does a place from where a straight way leads to it
   */
  leading(vertex: number, ways: Directions, goal: GoalInSight | null): Directions {
    const { vertices, looks } = this
    const cell = vertices.cell(vertex)
    let leading = ways & vertices.leading[vertex]
    let missing = ways & ~vertices.tried[vertex]
    while (missing !== 0 && (leading & (leading - 1)) === 0) {
      const d = 31 - Math.clz32(missing)
      missing ^= 1 << d
      if (looks.from(cell, d, null) >= 0) leading |= 1 << d
      vertices.tried[vertex] |= 1 << d
      vertices.views[vertex] = joined(vertices.views[vertex], looks.view)
    }
    vertices.leading[vertex] |= leading
    if ((leading & (leading - 1)) === 0 && goal && covers(vertices.views[vertex], goal.view)) {
      let dark = ways & ~leading
      while (dark !== 0) {
        const d = 31 - Math.clz32(dark)
        dark ^= 1 << d
        if (looks.from(cell, d, goal) >= 0) leading |= 1 << d
      }
    }
    return leading
  }
}
