import { type Direction, DX, DY, stepOffsets } from '../../../grid/directions'
import { type Cell, rowOf } from '../../../grid/grid'
import type { Problem } from '../../../grid/problem'
import { successorsUnder } from '../successors'
import type { GoalInSight } from './goal-in-sight'
import { Rounds } from './rounds'
import { runAlong, type StraightRuns, straightRuns } from './straight-runs'
import { type View, Viewer } from './views'

/** Looks from a cell along its ways for the next cell where a shortest path may turn. */
export class Looks {
  // Of the latest jump, what it weighs, and the direction of its last step:
  weight = 0
  arrival: Direction = 0
  readonly runs: readonly StraightRuns[]
  readonly #legal: Uint8Array
  readonly #successors: Uint8Array
  readonly #offsets: Int32Array
  readonly #diagonalWeight: number
  readonly #width: number
  readonly #share: number
  readonly #rounds = new Rounds()
  readonly #viewer: Viewer
  /** Around all that it looked at. */
  #left = 0
  #top = 0
  #right = 0
  #bottom = 0
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
    this.#viewer = new Viewer(grid)
  }

  /** What the latest jump looked at. */
  get view(): View {
    return this.#viewer.view(this.#left, this.#top, this.#right, this.#bottom)
  }

  /**
   * The jump point to which a legal step from `from` leads; -1 if it leads to none. A corner with one
   * way on is no choice: the jump goes round it.
   * @param goal to end at, or where a straight way leads to it; without one only choices are ends
   */
  from(from: Cell, departure: Direction, goal: GoalInSight | null): Cell {
    let cell = from
    let d = departure
    let y = rowOf(from, this.#share)
    let x = from - y * this.#width
    this.weight = 0
    this.#left = x
    this.#right = x
    this.#top = y
    this.#bottom = y
    this.#rounds.begin()
    do {
      let steps = d & 1 ? this.#diagonal(cell, x, y, d) : this.#straight(cell, d)
      const inSight = goal === null ? 0 : goal.on(cell, d, steps)
      if (inSight > 0) steps = inSight
      cell += steps * this.#offsets[d]
      x += steps * DX[d]
      y += steps * DY[d]
      this.#see(x, y)
      if (!this.#found && inSight === 0) return -1
      this.weight += d & 1 ? steps * this.#diagonalWeight : steps
      this.arrival = d
      const ways = this.#successors[(d << 8) | this.#legal[cell]]
      if (inSight > 0 || (ways & (ways - 1)) !== 0) return cell
      d = 31 - Math.clz32(ways)
    } while (!this.#rounds.isBack(cell, d))
    return -1
  }

  #see(x: number, y: number): void {
    this.#left = Math.min(this.#left, x)
    this.#right = Math.max(this.#right, x)
    this.#top = Math.min(this.#top, y)
    this.#bottom = Math.max(this.#bottom, y)
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
  #diagonal(from: Cell, x: number, y: number, d: Direction): number {
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
    // How far it looks to both sides in vain, as columns and rows. From where it stops, who goes on
    // looks to the sides.
    let columns = 0
    let rows = 0
    let steps = 1
    for (; ; steps++) {
      cell += offset
      acrossLine += acrossStep
      downLine += downStep
      const ways = successors[(d << 8) | legal[cell]]
      if ((ways & ~natural) !== 0) break
      if ((ways >> across) & 1) {
        const run = runAlong(acrossMarks, acrossLine, acrossPlace + steps)
        if (run > 0) break
        columns = Math.max(columns, steps - run)
      }
      if ((ways >> down) & 1) {
        const run = runAlong(downMarks, downLine, downPlace + steps)
        if (run > 0) break
        rows = Math.max(rows, steps - run)
      }
      if ((ways & onward) === 0) {
        this.#found = false
        break
      }
    }
    this.#see(x + columns * dx, y + rows * dy)
    return steps
  }
}
