import type { Cell } from '../../grid/grid'
import type { Directions } from '../../grid/steps'
import { EVENT } from '../../trace/events'
import type { Tape } from '../../trace/tape'
import { type Cost, costOfWeight } from '../costs'
import type { SearchTask } from './search'

/** Writes on a tape what a search over cells does. */
export class Recorder {
  readonly #tape: Tape
  readonly #lines: SearchTask['lines']
  readonly #cost: Cost
  #least = -1

  constructor(tape: Tape, lines: SearchTask['lines'], cost: Cost) {
    this.#tape = tape
    this.#lines = lines
    this.#cost = cost
  }

  begin(start: Cell): void {
    this.#tape.at(this.#lines.start).write(EVENT.open, start)
  }

  /** @param opened the directions of the neighbours to which it gives a shorter way */
  closed(cell: Cell, opened: Directions, weight: number): void {
    const cost = costOfWeight(this.#cost, weight)
    this.#tape.at(this.#lines.close).write(EVENT.close, cell, opened, cost)
  }

  /** What a path over the cell weighs at least; written when it is another than before. */
  least(cell: Cell, weight: number): void {
    const least = costOfWeight(this.#cost, weight)
    if (least === this.#least) return
    this.#least = least
    this.#tape.write(EVENT.value, cell, 0, least)
  }

  /** Jump points are far away, so each has an event of its own. */
  jumped(to: Cell, from: Cell, weight: number): void {
    const cost = costOfWeight(this.#cost, weight)
    this.#tape.at(this.#lines.jump).write(EVENT.open, to, from, cost)
  }
}
