import { describe, expect, it } from 'vitest'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { BLOCK, BlockIndex } from '../../src/render/block-index'
import { EdgeCover, edgeLines } from '../../src/render/edge-lines'
import { LineIndex } from '../../src/render/line-index'
import { isVisible, MOST_IN_VIEW, mayBeSeen, placeMap } from '../../src/render/placement'
import { SlicedIndex } from '../../src/render/sliced-index'
import { VertexIndex } from '../../src/render/vertex-index'
import { runToEnd } from '../../src/render/work'
import { Tape } from '../../src/trace/tape'

const COLUMNS = 300
const ROWS = 200
const CELLS = COLUMNS * ROWS

const random = randomNumbers(11)
const randomCells = (count: number) =>
  Int32Array.from({ length: count }, () => randomInteger(random, CELLS))

/** Some view of the map, from most of it to a few cells. */
function randomPlace() {
  const scale = 1 + randomInteger(random, 30)
  const left = 100 - randomInteger(random, COLUMNS * scale)
  const top = 100 - randomInteger(random, ROWS * scale)
  const screen = { width: 500, height: 400, pixel: 1 }
  return placeMap({ scale, left, top }, { width: COLUMNS, height: ROWS }, screen)
}

const place = (scale: number) =>
  placeMap(
    { scale, left: 0, top: 0 },
    { width: COLUMNS, height: ROWS },
    { width: 600, height: 400, pixel: 1 },
  )

const sorted = (cells: Iterable<number>) => Array.from(cells).sort((a, b) => a - b)

/** Lines as texts, in an order of their own. */
const linesOf = (pairs: ArrayLike<number>) =>
  Array.from({ length: pairs.length / 2 }, (_, i) => `${pairs[2 * i]}-${pairs[2 * i + 1]}`).sort()

/** Says that time is up after so many questions. */
function timeFor(questions: number): () => boolean {
  let asked = 0
  return () => ++asked >= questions
}

function newTape(columns = COLUMNS, rows = ROWS): Tape {
  const tape = new Tape()
  tape.begin(columns, rows)
  return tape
}

describe('blocks of cells', () => {
  const box = { left: 70, top: 10, right: 200, bottom: 130 }
  const isIn = (cell: number, margin: number) => {
    const [x, y] = [cell % COLUMNS, Math.floor(cell / COLUMNS)]
    const inColumns = x >= box.left - margin && x < box.right + margin
    return inColumns && y >= box.top - margin && y < box.bottom + margin
  }

  it('lead to all that lies in a box, and to nothing far from it', () => {
    const cells = randomCells(5000)
    const index = new BlockIndex(COLUMNS, ROWS)
    for (const cell of cells) index.add(cell)
    const visited: number[] = []
    index.visit(box, (i) => visited.push(i))
    expect(new Set(visited).size).toBe(visited.length)
    const inBox = [...cells.keys()].filter((i) => isIn(cells[i], 0))
    expect(visited).toEqual(expect.arrayContaining(inBox))
    expect(visited.every((i) => isIn(cells[i], BLOCK))).toBe(true)
  })

  it('know how many things lie in a box of whole blocks, and about how many in any', () => {
    const index = new BlockIndex(COLUMNS, ROWS)
    for (let cell = 0; cell < CELLS; cell++) index.add(cell)
    expect(index.estimate({ left: 64, top: 0, right: 192, bottom: 64 })).toBe(128 * 64)
    expect(index.estimate({ left: 10, top: 20, right: 30, bottom: 50 })).toBe(20 * 30)
    expect(
      index.estimate({ left: -20, top: -9, right: COLUMNS, bottom: ROWS }),
    ).toBeLessThanOrEqual(CELLS)
    expect(index.estimate({ left: -9, top: -9, right: 999, bottom: 999 })).toBe(CELLS)
  })
})

describe('vertices', () => {
  it('in view are those that a look at each finds, however they came', () => {
    const vertices = randomCells(10_000)
    const index = new VertexIndex(COLUMNS, ROWS)
    for (const length of [1, 900, 901, 10_000]) {
      runToEnd(index.take(vertices.slice(0, length), length))
      for (let i = 0; i < 20; i++) {
        const where = randomPlace()
        const seen = vertices.slice(0, length).filter((cell) => isVisible(where, cell))
        expect(sorted(index.inView(where) ?? [])).toEqual(sorted(seen))
      }
    }
  })

  it('are left out if there are too many, and come into sight as one zooms in', () => {
    const all = Int32Array.from({ length: CELLS }, (_, cell) => cell)
    expect(CELLS).toBeGreaterThan(MOST_IN_VIEW)
    const index = runToEnd(new VertexIndex(COLUMNS, ROWS).take(all, CELLS))
    expect(index.inView(place(2))).toBeNull()
    expect(index.inView(place(8))).not.toBeNull()
  })
})

describe('lines', () => {
  it('in view are those that a look at each finds, long ones too', () => {
    const index = new LineIndex(COLUMNS, ROWS)
    const edges = randomCells(2000)
    const lines = edgeLines(COLUMNS, ROWS, edges)
    for (let i = 0; i < lines.length; i += 2) index.add(lines[i], lines[i + 1])
    for (let i = 0; i < 50; i++) {
      const where = randomPlace()
      const seen: number[] = []
      for (let j = 0; j < lines.length; j += 2) {
        if (mayBeSeen(where, lines[j], lines[j + 1])) seen.push(lines[j], lines[j + 1])
      }
      expect(linesOf(index.inView(where) ?? [])).toEqual(linesOf(seen))
    }
  })

  it('are left out if there are too many', () => {
    const index = new LineIndex(COLUMNS, ROWS)
    for (let cell = 0; cell < CELLS - 1; cell++) index.add(cell, cell + 1)
    expect(index.inView(place(2))).toBeNull()
    expect(index.inView(place(8))).not.toBeNull()
  })
})

describe('an index that is made in slices', () => {
  const newLines = () => new SlicedIndex((columns, rows) => new EdgeCover(columns, rows))
  const whole = place(2)
  const shown = (index: SlicedIndex<LineIndex>) => linesOf(index.ready?.inView(whole) ?? [])
  const nothingElse = (edges: Int32Array) => linesOf(edgeLines(COLUMNS, ROWS, edges))
  // Short ones: so many of any length would cover most of the map.
  const manyEdges = Int32Array.from({ length: 80_000 }, (_, i) => {
    const cell = Math.floor(i / 2) % (CELLS - 2)
    return i % 2 === 0 ? cell - (cell % 4) : cell - (cell % 4) + 1
  })

  it('is that of the whole list, whatever the slices', () => {
    const [columns, rows] = [700, 300]
    const lines = linesOf(edgeLines(columns, rows, manyEdges))
    for (const questions of [1, 2, 3, 5]) {
      const index = newLines()
      const tape = newTape(columns, rows)
      let calls = 1
      while (!index.update(tape, manyEdges, timeFor(questions))) {
        expect(index.ready).toBeNull()
        calls++
      }
      if (questions === 1) expect(calls).toBeGreaterThan(12)
      const all = placeMap({ scale: 1, left: 0, top: 0 }, tape, {
        width: 700,
        height: 300,
        pixel: 1,
      })
      expect(linesOf(index.ready?.inView(all) ?? [])).toEqual(lines)
    }
  })

  it('is ready at once if it is small, however little time there is', () => {
    const index = newLines()
    const edges = randomCells(200)
    expect(index.update(newTape(), edges, () => true)).toBe(true)
    expect(shown(index)).toEqual(nothingElse(edges))
  })

  it('takes in what comes, in pieces, and starts anew when the list is shorter', () => {
    const index = newLines()
    const tape = newTape()
    const edges = randomCells(600)
    for (const length of [2, 100, 102, 600, 40, 0, 600]) {
      const some = edges.slice(0, length)
      expect(index.update(tape, some, () => true)).toBe(true)
      expect(shown(index)).toEqual(nothingElse(some))
    }
  })

  it('shows what was ready before until it is done, and goes on with what came meanwhile', () => {
    const index = newLines()
    const tape = newTape()
    const few = manyEdges.slice(0, 60)
    index.update(tape, few, () => true)
    const before = index.ready
    const most = manyEdges.slice(0, 70_000)
    expect(index.update(tape, most, () => true)).toBe(false)
    expect(index.ready).toBe(before)
    while (!index.update(tape, manyEdges, () => true)) expect(index.ready).not.toBeNull()
    expect(shown(index)).toEqual(nothingElse(manyEdges))
  })

  it('is another for each tape, and none on a map of another size until it is ready', () => {
    const index = newLines()
    const [first, second] = [randomCells(100), randomCells(100)]
    index.update(newTape(), first, () => true)
    const other = newTape()
    index.update(other, second, () => true)
    expect(shown(index)).toEqual(nothingElse(second))
    expect(index.update(newTape(), manyEdges, () => true)).toBe(false)
    expect(shown(index)).toEqual(nothingElse(second))
    expect(index.update(newTape(ROWS, COLUMNS), manyEdges, () => true)).toBe(false)
    expect(index.ready).toBeNull()
    index.update(other, second, () => true)
    expect(index.update(null, [], () => true)).toBe(true)
    expect(index.ready).toBeNull()
  })
})
