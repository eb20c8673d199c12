import { type Direction, DX, DY } from '../../grid/directions'
import { type Cell, rowOf } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { runAlong, type StraightRuns, straightRuns } from './straight-runs'

/** What was found out about the latest map, for which its legal steps stand. */
let kept: { legal: Uint8Array; runs: readonly StraightRuns[] } | null = null

function runsOf(legal: Uint8Array, { grid, diagonal }: Problem): readonly StraightRuns[] {
  if (kept?.legal !== legal) kept = { legal, runs: straightRuns(grid, diagonal) }
  return kept.runs
}

/** Looks along diagonals, and from each of their cells straight to both sides, for places to turn. */
export class Diagonals {
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  readonly #offsets: Int32Array
  readonly #width: number
  readonly #share: number
  readonly #goalX: number
  readonly #goalY: number
  readonly #runs: readonly StraightRuns[]

  constructor(legal: Uint8Array, successors: Uint8Array, offsets: Int32Array, problem: Problem) {
    const { width } = problem.grid
    this.#legal = legal
    this.#successors = successors
    this.#offsets = offsets
    this.#width = width
    this.#share = 1 / width
    this.#goalX = problem.goal % width
    this.#goalY = Math.floor(problem.goal / width)
    this.#runs = runsOf(legal, problem)
  }

  /**
   * Steps in direction `d` to the goal or to the first cell that is round an obstacle's corner, or
   * from where a straight way leads to a choice or the goal; 0 if there is none.
   */
  steps(from: Cell, d: Direction): number {
    const legal = this.#legal
    const successors = this.#successors
    const offset = this.#offsets[d]
    const dx = DX[d]
    const dy = DY[d]
    const across = 4 - 2 * dx
    const down = 2 + 2 * dy
    const onward = 1 << d
    const natural = onward | (1 << across) | (1 << down)
    // Where it is, on the lines to both sides and as seen from the goal.
    const y = rowOf(from, this.#share)
    const x = from - y * this.#width
    const acrossRuns = this.#runs[across]
    const downRuns = this.#runs[down]
    const acrossMarks = acrossRuns.marks
    const downMarks = downRuns.marks
    const acrossStep = dy * acrossRuns.wordsEach
    const downStep = dx * downRuns.wordsEach
    let acrossLine = y * acrossRuns.wordsEach
    let downLine = x * downRuns.wordsEach
    const acrossPlace = acrossRuns.first + x * dx + 1
    const downPlace = downRuns.first + y * dy + 1
    const goalAcross = (this.#goalX - x) * dx
    const goalDown = (this.#goalY - y) * dy

    let cell = from
    let ways = onward
    for (let steps = 1; (ways & onward) !== 0; steps++) {
      cell += offset
      acrossLine += acrossStep
      downLine += downStep
      ways = successors[(d << 8) | legal[cell]]
      if ((ways & ~natural) !== 0) return steps
      if ((ways >> across) & 1) {
        const run = runAlong(acrossMarks, acrossLine, acrossPlace + steps)
        if (run > 0 || (goalDown === steps && isWithin(goalAcross - steps, -run))) return steps
      }
      if ((ways >> down) & 1) {
        const run = runAlong(downMarks, downLine, downPlace + steps)
        if (run > 0 || (goalAcross === steps && isWithin(goalDown - steps, -run))) return steps
      }
      if (goalAcross === steps && goalDown === steps) return steps
    }
    return 0
  }
}

const isWithin = (steps: number, most: number): boolean => steps > 0 && steps <= most
