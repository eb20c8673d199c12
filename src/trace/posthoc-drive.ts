import type { Cell } from '../grid/grid'
import { EVENT, type EventKind } from './events'
import type { PosthocLines } from './posthoc-lines'

/**
 * The events of a rover or an agent, as Posthoc's. A rover comes to a cell more than once, so each
 * step has an `id` of its own and the step before as `pId`. What the rover does at a step has the
 * step's `id`; what it learns there of other cells has theirs, and the step as `pId`.
 */
export class PosthocDrive {
  readonly #lines: PosthocLines
  #steps = 0
  #rover = -1
  /** The latest cell of the m-line. */
  #mLine = -1

  constructor(lines: PosthocLines) {
    this.#lines = lines
  }

  get hasBegun(): boolean {
    return this.#steps > 0
  }

  write(kind: EventKind, cell: Cell, other: number, value: number): void {
    const lines = this.#lines
    const step = this.#steps > 0 ? `step ${this.#steps - 1}` : null
    switch (kind) {
      case EVENT.step:
        this.#steps++
        this.#rover = cell
        this.#here('step')
        break
      case EVENT.sense:
        lines.cell('sense', cell, step).tell('obstacle', String(other === 1))
        break
      case EVENT.target:
        this.#ahead('target', cell, step).tellNumber('distance', value)
        break
      case EVENT.mLine:
        lines.cell('m-line', cell, lines.idIfKnown(this.#mLine))
        this.#mLine = cell
        break
      case EVENT.hit:
        this.#here('hit').tellNumber('number', value)
        if (other < 0) lines.tell('obstacle', '"the border of the map"')
        else lines.tellPlace('obstacleX', 'obstacleY', other)
        break
      case EVENT.feel:
        this.#ahead('feel', cell, step)
        break
      case EVENT.around:
        this.#here('around').tellNumber('steps', value)
        break
      case EVENT.leave:
        this.#here('leave').tellNumber('number', value)
        break
      case EVENT.loop:
        this.#here('loop').tellNumber('since', value)
        break
      case EVENT.scan:
        this.#here('scan')
        break
      case EVENT.node:
        this.#ahead('node', cell, step).tellNumber('distance', value)
        break
    }
  }

  end(): void {
    this.#here('end')
  }

  /** An event of another cell than the rover's; outside the map there is no place for it. */
  #ahead(type: string, cell: Cell, step: string | null): PosthocLines {
    return cell < 0 ? this.#here(`${type}-outside`) : this.#lines.cell(type, cell, step)
  }

  /** An event at the step and in the place where the rover is; before the first step, at none. */
  #here(type: string): PosthocLines {
    const before = this.#steps > 1 ? `step ${this.#steps - 2}` : null
    const id = this.#steps > 0 ? `step ${this.#steps - 1}` : type
    return this.#lines.begin(type, id, before, this.#rover)
  }
}
