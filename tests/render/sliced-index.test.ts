import { describe, expect, it } from 'vitest'
import { EdgeCover, edgeLines } from '../../src/render/edge-lines'
import type { LineIndex } from '../../src/render/line-index'
import { placeMap } from '../../src/render/placement'
import { SlicedIndex } from '../../src/render/sliced-index'
import { Tape } from '../../src/trace/tape'
import { CELLS, COLUMNS, linesOf, place, ROWS, randomCells } from './indexed-map'
import { runToEnd } from './run-to-end'

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

describe('an index that is made in slices', () => {
  const newLines = () => new SlicedIndex((columns, rows) => new EdgeCover(columns, rows))
  const whole = place(2)
  const shown = (index: SlicedIndex<LineIndex>) => linesOf(index.ready?.inView(whole) ?? [])
  const nothingElse = (edges: Int32Array) => linesOf(runToEnd(edgeLines(COLUMNS, ROWS, edges)))
  // Short ones: so many of any length would cover most of the map.
  const manyEdges = Int32Array.from({ length: 80_000 }, (_, i) => {
    const cell = Math.floor(i / 2) % (CELLS - 2)
    return i % 2 === 0 ? cell - (cell % 4) : cell - (cell % 4) + 1
  })

  it('is that of the whole list, whatever the slices', () => {
    const [columns, rows] = [700, 300]
    const lines = linesOf(runToEnd(edgeLines(columns, rows, manyEdges)))
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
    // A plan without a roadmap, and none at all.
    for (const tape of [newTape(), null]) {
      index.update(other, second, () => true)
      expect(index.ready).not.toBeNull()
      expect(index.update(tape, [], () => true)).toBe(true)
      expect([index.ready, index.readyLength]).toEqual([null, 0])
    }
  })
})
