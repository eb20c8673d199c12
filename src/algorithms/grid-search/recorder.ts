import type { Cell } from '../../grid/grid'
import type { Directions } from '../../grid/steps'
import { EVENT } from '../../trace/events'
import type { Tape } from '../../trace/tape'
import { type Cost, costOfWeight } from '../costs'
import type { SearchTask } from './search'

/** Writes on a tape what a search over cells does. */
export class Recorder {
  readonly #tape: Tape
  readonly #startLine: number
  readonly #closeLine: number
  readonly #jumpLine: number
  readonly #cost: Cost

  constructor(tape: Tape, { start, close, jump }: SearchTask['lines'], cost: Cost) {
    this.#tape = tape
    this.#startLine = start
    this.#closeLine = close
    this.#jumpLine = jump
    this.#cost = cost
  }

  /** @param goal to which A* reckons what is left */
  begin(start: Cell, goal: Cell | null): void {
    this.#tape.at(this.#startLine).write(EVENT.open, start)
    if (goal !== null) this.#tape.write(EVENT.estimate, goal, 0)
  }

  /** @param opened the directions of the neighbours to which it gives a shorter way */
  closed(cell: Cell, opened: Directions): void {
    this.#tape.writeAt(this.#closeLine, EVENT.close, cell, opened, 0)
  }

  jumpPointClosed(cell: Cell, weight: number): void {
    const cost = costOfWeight(this.#cost, weight)
    this.#tape.writeAt(this.#closeLine, EVENT.close, cell, -1, cost)
  }

  /** Jump points are far away, so each has an event of its own. */
  jumped(to: Cell, from: Cell, weight: number): void {
    const cost = costOfWeight(this.#cost, weight)
    this.#tape.writeAt(this.#jumpLine, EVENT.open, to, from, cost)
  }
}
