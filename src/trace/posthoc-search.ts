import type { Cell } from '../grid/grid'
import { EVENT, type EventKind } from './events'
import type { PosthocLines } from './posthoc-lines'

/**
 * The events of a planner that sees the map, as Posthoc's. All that happens to a cell has the
 * cell's `id`, and its parent's as `pId`.
 */
export class PosthocSearch {
  readonly #lines: PosthocLines
  readonly #parents: Int32Array
  readonly #costs: Float64Array
  readonly #opened: Uint8Array
  /** The cell that is being expanded: closed as soon as something else happens. */
  #expanding = -1
  #pathCells = 0

  constructor(lines: PosthocLines, cells: number) {
    this.#lines = lines
    this.#parents = new Int32Array(cells).fill(-1)
    this.#costs = new Float64Array(cells)
    this.#opened = new Uint8Array(cells)
  }

  /** The cost of the way to a cell that is known so far. */
  costOf(cell: Cell): number {
    return this.#costs[cell]
  }

  /** Closes the cell that was expanded, before an event that is none of its expansion. */
  before(kind: EventKind): void {
    if (this.#expanding < 0 || kind === EVENT.open) return
    this.#searched('closing', this.#expanding)
    this.#expanding = -1
  }

  write(kind: EventKind, cell: Cell, other: number, value: number): void {
    switch (kind) {
      case EVENT.row:
        // No cell's event: it would make a root of each row's first cell.
        this.#lines.begin('row', `row ${this.#lines.id(cell)}`, null, cell)
        this.#lines.tellNumber('cells', other)
        break
      case EVENT.test:
        this.#lines.cell('test', cell).tellPlace('obstacleX', 'obstacleY', other)
        this.#lines.tell('corner', String(value === 1))
        break
      case EVENT.vertex:
        this.#lines.cell('vertex', cell)
        break
      case EVENT.edge:
        this.#between('edge', cell, other).tellNumber('weight', value)
        break
      case EVENT.cut:
        this.#lines.begin('cut', 'cut', null, -1).tellNumber('edges', value)
        break
      case EVENT.refuse:
        this.#between('refuse', cell, other).tellPlace('atX', 'atY', value)
        break
      case EVENT.open:
        this.open(cell, other, value)
        break
      case EVENT.close:
        this.#expanding = cell
        if (other < 0) this.#costs[cell] = value
        this.#searched('expanding', cell)
        break
      case EVENT.path:
        this.#path(cell)
        break
      case EVENT.attraction:
        this.#lines.cell('attraction', cell).tellNumber('value', value)
        break
      case EVENT.repulsion:
        this.#lines.cell('repulsion', cell).tellNumber('value', value)
        break
      case EVENT.potential:
        this.#lines.cell('potential', cell).tellNumber('value', value)
        break
    }
  }

  /** A cell was reached, for the first time or by a shorter way. */
  open(cell: Cell, parent: Cell, cost: number): void {
    const type = this.#opened[cell] ? 'updating' : 'generating'
    this.#opened[cell] = 1
    this.#parents[cell] = parent
    this.#costs[cell] = cost
    this.#searched(type, cell)
  }

  end(cell: Cell): void {
    if (cell < 0) this.#lines.begin('end', 'end', null, -1)
    else this.#lines.cell('end', cell, this.#lines.idIfKnown(this.#parents[cell]))
  }

  #searched(type: string, cell: Cell): void {
    const parent = this.#lines.idIfKnown(this.#parents[cell])
    this.#lines.cell(type, cell, parent).tellNumber('g', this.#costs[cell])
  }

  #between(type: string, from: Cell, to: Cell): PosthocLines {
    const id = `${this.#lines.id(from)}-${this.#lines.id(to)}`
    this.#lines.begin(type, id, this.#lines.idIfKnown(from), from)
    return this.#lines.tellPlace('toX', 'toY', to)
  }

  /** The path is a chain of its own: on a roadmap it leads over cells that the search never saw. */
  #path(cell: Cell): void {
    const number = this.#pathCells++
    this.#lines.begin('path', `path ${number}`, number > 0 ? `path ${number - 1}` : null, cell)
  }
}
