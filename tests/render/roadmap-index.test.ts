import { describe, expect, it } from 'vitest'
import { randomInteger } from '../../src/grid/random'
import { edgeLines } from '../../src/render/edge-lines'
import { LineIndex } from '../../src/render/line-index'
import { isVisible, MOST_IN_VIEW, mayBeSeen, placeMap } from '../../src/render/placement'
import { VertexIndex } from '../../src/render/vertex-index'
import { CELLS, COLUMNS, linesOf, place, ROWS, random, randomCells } from './indexed-map'
import { runToEnd } from './run-to-end'

/** Some view of the map, from most of it to a few cells. */
function randomPlace() {
  const scale = 1 + randomInteger(random, 30)
  const left = 100 - randomInteger(random, COLUMNS * scale)
  const top = 100 - randomInteger(random, ROWS * scale)
  const screen = { width: 500, height: 400, pixel: 1 }
  return placeMap({ scale, left, top }, { width: COLUMNS, height: ROWS }, screen)
}

const sorted = (cells: Iterable<number>) => Array.from(cells).sort((a, b) => a - b)

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
    const lines = runToEnd(edgeLines(COLUMNS, ROWS, edges))
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
