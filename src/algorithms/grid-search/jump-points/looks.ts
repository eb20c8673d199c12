import { type Direction, DX, DY, stepOffsets } from '../../../grid/directions'
import { type Cell, rowOf } from '../../../grid/grid'
import type { Problem } from '../../../grid/problem'
import { cellDistance } from '../../../grid/simplest-path'
import { successorsUnder } from '../successors'
import type { GoalInSight } from './goal-in-sight'
import { Rounds } from './rounds'
import { runAlong, type StraightRuns, straightRuns } from './straight-runs'

/** Looks from a cell along its ways for the next cell where a shortest path may turn. */
export class Looks {
  // Of the latest jump, what it weighs, the direction of its last step, and how many columns or rows
  // away its cells are at most:
  weight = 0
  arrival: Direction = 0
  view = 0
  readonly runs: readonly StraightRuns[]
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  readonly #offsets: Int32Array
  readonly #diagonalWeight: number
  readonly #width: number
  readonly #share: number
  readonly #rounds = new Rounds()
  /** Whether the latest steps led to a choice, or to a corner with one way on. */
  #found = false

  constructor(legal: Uint8Array, { grid, diagonal }: Problem, diagonalWeight: number) {
    this.runs = straightRuns(grid, diagonal)
    this.#legal = legal
    this.#successors = successorsUnder(diagonal)
    this.#offsets = stepOffsets(grid.width)
    this.#diagonalWeight = diagonalWeight
    this.#width = grid.width
    this.#share = 1 / grid.width
  }

  /**
   * The jump point to which a legal step from `from` leads; -1 if it leads to none. A corner with one
   * way on is no choice: the jump goes round it.
   * @param goal to end at, or where a straight way leads to it; without one only choices are ends
   */
  from(from: Cell, departure: Direction, goal: GoalInSight | null): Cell {
    let cell = from
    let d = departure
    this.weight = 0
    this.view = 0
    this.#rounds.begin()
    do {
      let steps = d & 1 ? this.#diagonal(cell, d) : this.#straight(cell, d)
      const inSight = goal === null ? 0 : goal.on(cell, d, steps)
      if (inSight > 0) steps = inSight
      cell += steps * this.#offsets[d]
      this.view = Math.max(this.view, cellDistance(from, cell, this.#width, this.#share))
      if (!this.#found && inSight === 0) return -1
      this.weight += d & 1 ? steps * this.#diagonalWeight : steps
      this.arrival = d
      const ways = this.#successors[(d << 8) | this.#legal[cell]]
      if (inSight > 0 || (ways & (ways - 1)) !== 0) return cell
      d = 31 - Math.clz32(ways)
    } while (!this.#rounds.isBack(cell, d))
    return -1
  }

  /** Steps to a cell with another way than onward, or to the last one. Few: to count them is quick. */
  #straight(from: Cell, d: Direction): number {
    const legal = this.#legal
    const successors = this.#successors
    const offset = this.#offsets[d]
    const row = d << 8
    const onward = 1 << d
    let cell = from
    let steps = 0
    let ways = onward
    while (ways === onward) {
      cell += offset
      steps++
      ways = successors[row | legal[cell]]
    }
    this.#found = ways !== 0
    return steps
  }

  /** Steps to a cell round an obstacle's corner, or from where a straight way leads to a choice. */
  #diagonal(from: Cell, d: Direction): number {
    const y = rowOf(from, this.#share)
    const x = from - y * this.#width
    const legal = this.#legal
    const successors = this.#successors
    const offset = this.#offsets[d]
    const dx = DX[d]
    const dy = DY[d]
    const across = 4 - 2 * dx
    const down = 2 + 2 * dy
    const onward = 1 << d
    const natural = onward | (1 << across) | (1 << down)
    // Where it is, on the lines to both sides.
    const acrossRuns = this.runs[across]
    const downRuns = this.runs[down]
    const acrossMarks = acrossRuns.marks
    const downMarks = downRuns.marks
    const acrossStep = dy * acrossRuns.wordsEach
    const downStep = dx * downRuns.wordsEach
    let acrossLine = y * acrossRuns.wordsEach
    let downLine = x * downRuns.wordsEach
    const acrossPlace = acrossRuns.first + x * dx + 1
    const downPlace = downRuns.first + y * dy + 1

    this.#found = true
    let cell = from
    for (let steps = 1; ; steps++) {
      cell += offset
      acrossLine += acrossStep
      downLine += downStep
      const ways = successors[(d << 8) | legal[cell]]
      if ((ways & ~natural) !== 0) return steps
      if ((ways >> across) & 1 && runAlong(acrossMarks, acrossLine, acrossPlace + steps) > 0) {
        return steps
      }
      if ((ways >> down) & 1 && runAlong(downMarks, downLine, downPlace + steps) > 0) return steps
      if ((ways & onward) === 0) {
        this.#found = false
        return steps
      }
    }
  }
}
