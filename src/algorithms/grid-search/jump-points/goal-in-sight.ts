import { type Direction, DX, DY } from '../../../grid/directions'
import { type Cell, rowOf } from '../../../grid/grid'
import type { Problem } from '../../../grid/problem'
import { runFrom, type StraightRuns } from './straight-runs'

/** Tells where the goal comes in sight of a jump: it is reached, or a straight way leads to it. */
export class GoalInSight {
  readonly #runs: readonly StraightRuns[]
  readonly #goal: Cell
  readonly #width: number
  readonly #share: number
  readonly #x: number
  readonly #y: number
  /** How many steps it sees to the north and so on. */
  readonly #north: number
  readonly #east: number
  readonly #south: number
  readonly #west: number

  constructor(
    { goal, grid: { width } }: Problem,
    legal: Uint8Array,
    runs: readonly StraightRuns[],
  ) {
    this.#runs = runs
    this.#goal = goal
    this.#width = width
    this.#share = 1 / width
    this.#x = goal % width
    this.#y = Math.floor(goal / width)
    const steps = (d: Direction) => {
      let count = 0
      for (let cell = goal; (legal[cell] >> d) & 1; cell += DX[d] + DY[d] * width) count++
      return count
    }
    this.#north = steps(0)
    this.#east = steps(2)
    this.#south = steps(4)
    this.#west = steps(6)
  }

  isAt(cell: Cell): boolean {
    return cell === this.#goal
  }

  /** Whether it could be in sight of jumps that look up to so many columns or rows away from a cell. */
  isNear(cell: Cell, view: number): boolean {
    const y = rowOf(cell, this.#share)
    const x = cell - y * this.#width
    const right = x - this.#x
    const below = y - this.#y
    if (Math.abs(right) <= view) {
      return below >= -this.#north - view && below <= this.#south + view
    }
    return Math.abs(below) <= view && right >= -this.#west - view && right <= this.#east + view
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
