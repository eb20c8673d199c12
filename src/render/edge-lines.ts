import { directionOf } from '../grid/directions'
import type { Cell } from '../grid/grid'
import type { Cells } from '../trace/frame'
import { LineIndex } from './line-index'
import type { Indexer } from './sliced-index'
import type { Work } from './work'

/** East to south-west: a line in any of the other directions is one of these from its other end. */
const ONWARD = [2, 3, 4, 5] as const

/** So many edges, or cells, are worked through within a fraction of a frame. */
const EDGES_AT_ONCE = 1 << 13
const CELLS_AT_ONCE = 1 << 16

/**
 * What a roadmap's edges cover, as straight lines that do not overlap: an edge is the simplest path
 * between two cells, and thousands of edges run along the same few lines between cells' centres.
 * @param edges pairs of cells, one after the other
 * @returns pairs of cells as well, the ends of the lines
 */
export function* edgeLines(columns: number, rows: number, edges: Cells): Work<Cell[]> {
  if (edges.length === 0) return []
  const lines: Cell[] = []
  const cover = new EdgeCover(columns, rows)
  yield* cover.add(edges, edges.length)
  yield* cover.collect((from, to) => lines.push(from, to))
  return lines
}

/** What edges cover of a map. Edges may be added, and the lines collected, in turn. */
export class EdgeCover implements Indexer<LineIndex> {
  readonly #columns: number
  readonly #rows: number
  /** For each direction and cell: how many edges begin there, less those that end. */
  readonly #changes: Int32Array[] = []
  #added = 0

  constructor(columns: number, rows: number) {
    this.#columns = columns
    this.#rows = rows
  }

  *take(edges: Cells, length: number): Work<LineIndex> {
    yield* this.add(edges, length)
    const lines = new LineIndex(this.#columns, this.#rows)
    yield* this.collect((from, to) => lines.add(from, to))
    return lines
  }

  /** Adds those of the first `length` entries of a list that are not yet added. */
  *add(edges: Cells, length: number): Work<void> {
    const cells = this.#columns * this.#rows
    while (this.#changes.length < ONWARD.length) {
      this.#changes.push(new Int32Array(cells))
      if (cells > CELLS_AT_ONCE) yield
    }
    while (this.#added < length) {
      const to = Math.min(length, this.#added + 2 * EDGES_AT_ONCE)
      for (let i = this.#added; i + 1 < to; i += 2) this.#addEdge(edges[i], edges[i + 1])
      this.#added = to
      if (to < length) yield
    }
  }

  /** Visits each line: from its northern end to the other one, a horizontal line from west to east. */
  *collect(visit: (from: Cell, to: Cell) => void): Work<void> {
    const [columns, rows] = [this.#columns, this.#rows]
    const rowsAtOnce = Math.ceil(CELLS_AT_ONCE / columns)
    for (let i = 0; i < ONWARD.length; i++) {
      // Along each of the parallel lines of this direction: how many edges cover it, and since where.
      const covering = new Int32Array(columns + rows)
      const since = new Int32Array(columns + rows)
      for (let row = 0; row < rows; row += rowsAtOnce) {
        if (row > 0) yield
        this.#collectRows(i, row, Math.min(rows, row + rowsAtOnce), covering, since, visit)
      }
    }
  }

  #collectRows(
    i: number,
    fromRow: number,
    toRow: number,
    covering: Int32Array,
    since: Int32Array,
    visit: (from: Cell, to: Cell) => void,
  ): void {
    const [columns, rows] = [this.#columns, this.#rows]
    const changes = this.#changes[i]
    const perColumn = ONWARD[i] === 2 ? 0 : 1
    for (let y = fromRow; y < toRow; y++) {
      // The numbers of the parallel lines through the row's first cell and, by `perColumn`, the others.
      const first = [y, rows - 1 - y, 0, y][i]
      const row = y * columns
      for (let x = 0; x < columns; x++) {
        const change = changes[row + x]
        if (change === 0) continue
        const line = first + x * perColumn
        if (covering[line] === 0) since[line] = row + x
        covering[line] += change
        if (covering[line] === 0) visit(since[line], row + x)
      }
    }
  }

  #addEdge(from: Cell, to: Cell): void {
    const columns = this.#columns
    const fromX = from % columns
    const dx = (to % columns) - fromX
    const dy = Math.floor(to / columns) - (from - fromX) / columns
    // Where its simplest path stops being diagonal.
    const diagonal = Math.min(Math.abs(dx), Math.abs(dy))
    const bendX = Math.sign(dx) * diagonal
    const bendY = Math.sign(dy) * diagonal
    const bend = from + bendY * columns + bendX
    if (diagonal > 0) this.#addLine(from, bend, bendX, bendY)
    if (bend !== to) this.#addLine(bend, to, dx - bendX, dy - bendY)
  }

  #addLine(from: Cell, to: Cell, dx: number, dy: number): void {
    const direction = directionOf(dx, dy)
    const isOnward = direction >= 2 && direction <= 5
    const changes = this.#changes[(isOnward ? direction : direction ^ 4) - 2]
    changes[isOnward ? from : to]++
    changes[isOnward ? to : from]--
  }
}
