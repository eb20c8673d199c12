import { type Direction, DX, DY } from '../../../grid/directions'
import { type Cell, rowOf } from '../../../grid/grid'
import type { Problem } from '../../../grid/problem'
import { runFrom, type StraightRuns } from './straight-runs'
import { type View, Viewer } from './views'

/** Tells where the goal comes in sight of a jump: it is reached, or a straight way leads to it. */
export class GoalInSight {
  readonly #runs: readonly StraightRuns[]
  readonly #goal: Cell
  readonly #width: number
  readonly #share: number
  readonly #x: number
  readonly #y: number
  /** Its cell alone: it may be in sight of those only who looked at it. */
  readonly view: View

  constructor({ goal, grid }: Problem, runs: readonly StraightRuns[]) {
    const { width } = grid
    this.#runs = runs
    this.#goal = goal
    this.#width = width
    this.#share = 1 / width
    this.#x = goal % width
    this.#y = Math.floor(goal / width)
    this.view = new Viewer(grid).view(this.#x, this.#y, this.#x, this.#y)
  }

  isAt(cell: Cell): boolean {
    return cell === this.#goal
  }

  /** After how many of the steps from a cell in direction `d` it comes in sight; 0 if it does not. */
  on(cell: Cell, d: Direction, steps: number): number {
    const y = rowOf(cell, this.#share)
    const x = cell - y * this.#width
    const across = this.#x - x
    const down = this.#y - y
    if ((d & 1) === 0) {
      if ((DX[d] === 0 ? across : down) !== 0) return 0
      const straight = across * DX[d] + down * DY[d]
      return straight <= steps ? Math.max(0, straight) : 0
    }
    const turn = Math.min(across * DX[d], down * DY[d])
    return turn > 0 && turn <= steps && this.#isSeen(x + turn * DX[d], y + turn * DY[d]) ? turn : 0
  }

  /** Whether the goal is in one row or column with (x, y), and no choice on the way comes before it. */
  #isSeen(x: number, y: number): boolean {
    const across = this.#x - x
    const down = this.#y - y
    if (across === 0 && down === 0) return true
    const d = across === 0 ? 2 + 2 * Math.sign(down) : 4 - 2 * Math.sign(across)
    return Math.abs(across + down) <= Math.abs(runFrom(this.#runs[d], x, y, d))
  }
}
