import { type Direction, DX, DY } from '../../grid/directions'
import type { Cell } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { type Memory, OPEN } from './memory'
import { runAlong, type StraightRuns, straightRuns } from './straight-runs'

/** What was found out about the latest map, for which its legal steps stand. */
let kept: { legal: Uint8Array; runs: readonly StraightRuns[] } | null = null

function runsOf(legal: Uint8Array, { grid, diagonal }: Problem): readonly StraightRuns[] {
  if (kept?.legal !== legal) kept = { legal, runs: straightRuns(grid, diagonal) }
  return kept.runs
}

/** Looks from a cell along its ways for the next cell where a shortest path may turn. */
export class Jumps {
  /** Where the latest jump ended: the weight of the path, and the direction of its last step. */
  weight = 0
  direction: Direction = 0
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  readonly #offsets: Int32Array
  readonly #width: number
  readonly #share: number
  readonly #diagonalWeight: number
  readonly #goal: Cell
  readonly #goalX: number
  readonly #goalY: number
  readonly #memory: Memory
  readonly #runs: readonly StraightRuns[]

  constructor(
    legal: Uint8Array,
    successors: Uint8Array,
    offsets: Int32Array,
    diagonalWeight: number,
    problem: Problem,
    memory: Memory,
  ) {
    const { goal } = problem
    const { width } = problem.grid
    this.#legal = legal
    this.#successors = successors
    this.#offsets = offsets
    this.#width = width
    this.#share = 1 / width
    this.#diagonalWeight = diagonalWeight
    this.#goal = goal
    this.#goalX = goal % width
    this.#goalY = Math.floor(goal / width)
    this.#memory = memory
    this.#runs = runsOf(legal, problem)
  }

  /**
   * The jump point to which a legal step from `from` leads; -1 if it leads to none, or not by a
   * shorter path than is known. A corner with one way on is no choice, so it is noted and passed.
   */
  from(from: Cell, direction: Direction, weight: number): Cell {
    const { states, weights } = this.#memory
    let cell = from
    let d = direction
    let length = weight
    for (;;) {
      const steps = d & 1 ? this.#diagonally(cell, d) : this.#straight(cell, d)
      if (steps === 0) return -1
      length += steps * (d & 1 ? this.#diagonalWeight : 1)
      cell += steps * this.#offsets[d]
      const ways = this.#successors[(d << 8) | this.#legal[cell]]
      if (cell === this.#goal || (ways & (ways - 1)) !== 0) break
      if (states[cell] !== 0 && length >= weights[cell]) return -1
      states[cell] = OPEN | d
      weights[cell] = length
      d = 31 - Math.clz32(ways)
    }
    this.weight = length
    this.direction = d
    return cell
  }

  /** Steps to the first cell with another way than onward, or to the goal; 0 if the way ends before. */
  #straight(from: Cell, d: Direction): number {
    const legal = this.#legal
    const successors = this.#successors
    const goal = this.#goal
    const offset = this.#offsets[d]
    const row = d << 8
    const onward = 1 << d
    let cell = from
    let steps = 0
    let ways = onward
    while (ways === onward) {
      cell += offset
      steps++
      if (cell === goal) return steps
      ways = successors[row | legal[cell]]
    }
    return ways === 0 ? 0 : steps
  }

  /** Steps to the first cell round an obstacle's corner, or with a jump point straight to a side; or the goal; 0 if there is none. */
  #diagonally(from: Cell, d: Direction): number {
    const legal = this.#legal
    const successors = this.#successors
    const width = this.#width
    const fromY = ((from + 0.5) * this.#share) | 0
    const fromX = from - fromY * width
    const dx = DX[d]
    const dy = DY[d]
    const across = 4 - 2 * dx
    const down = 2 + 2 * dy
    const acrossRuns = this.#runs[across]
    const downRuns = this.#runs[down]
    const acrossMarks = acrossRuns.marks
    const downMarks = downRuns.marks
    const rowStep = dy * acrossRuns.wordsEach
    const columnStep = dx * downRuns.wordsEach
    const offset = this.#offsets[d]
    const onward = 1 << d
    const natural = onward | (1 << across) | (1 << down)
    // From here to the goal.
    const goalAcross = (this.#goalX - fromX) * dx
    const goalDown = (this.#goalY - fromY) * dy
    let placeAcross = acrossRuns.first + fromX * dx
    let placeDown = downRuns.first + fromY * dy
    let row = fromY * acrossRuns.wordsEach
    let column = fromX * downRuns.wordsEach
    let cell = from
    let ways = onward
    for (let steps = 1; (ways & onward) !== 0; steps++) {
      placeAcross++
      placeDown++
      row += rowStep
      column += columnStep
      cell += offset
      ways = successors[(d << 8) | legal[cell]]
      if ((ways & ~natural) !== 0) return steps
      if ((ways >> across) & 1) {
        const run = runAlong(acrossMarks, row, placeAcross + 1)
        if (run > 0 || (goalDown === steps && isWithin(goalAcross - steps, -run))) return steps
      }
      if ((ways >> down) & 1) {
        const run = runAlong(downMarks, column, placeDown + 1)
        if (run > 0 || (goalAcross === steps && isWithin(goalDown - steps, -run))) return steps
      }
      if (goalAcross === steps && goalDown === steps) return steps
    }
    return 0
  }
}

const isWithin = (steps: number, most: number): boolean => steps > 0 && steps <= most
