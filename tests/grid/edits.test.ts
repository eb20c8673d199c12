import fc from 'fast-check'
import { expect, it } from 'vitest'
import { editedCells } from '../../src/grid/edits'
import { emptyGrid, type Grid, withCells } from '../../src/grid/grid'

const WIDTH = 7
const HEIGHT = 5
const CELLS = WIDTH * HEIGHT

const strokes = fc.array(
  fc.record({
    cells: fc.array(fc.nat({ max: CELLS - 1 }), { maxLength: 6 }),
    obstacle: fc.boolean(),
  }),
  { maxLength: 25 },
)

/** Compared one by one. */
function naiveDifferences(a: Uint8Array, b: Uint8Array): number[] {
  return [...a.keys()].filter((cell) => a[cell] !== b[cell])
}

function differing(a: Uint8Array, b: Uint8Array): number[] {
  const cells = new Set(editedCells(a, b))
  return [...cells].filter((cell) => a[cell] !== b[cell]).sort((p, q) => p - q)
}

it('names each cell in which two maps differ, whether or not one was made of the other', () => {
  fc.assert(
    fc.property(strokes, fc.nat(), fc.nat(), (list, i, j) => {
      const grids: Grid[] = [emptyGrid(WIDTH, HEIGHT)]
      for (const { cells, obstacle } of list) {
        grids.push(withCells(grids[grids.length - 1], cells, obstacle))
      }
      const { walls: a } = grids[i % grids.length]
      const { walls: b } = grids[j % grids.length]
      expect(differing(a, b)).toEqual(naiveDifferences(a, b))
      expect(differing(a.slice(), b)).toEqual(naiveDifferences(a, b))
    }),
  )
})

it('compares maps that begin anywhere in their memory', () => {
  const bytes = Uint8Array.from({ length: 4 * CELLS }, (_, i) => ((i * i) % 3) & 1)
  for (const offset of [1, 2, 4]) {
    const a = bytes.subarray(offset, offset + CELLS)
    const b = bytes.subarray(40, 40 + CELLS)
    expect(differing(a, b)).toEqual(naiveDifferences(a, b))
  }
})

it('looks at no other cells than those of a stroke', () => {
  const before = emptyGrid(WIDTH, HEIGHT)
  const stroke = withCells(withCells(before, [3], true), [4, 5], true)
  expect([...editedCells(before.walls, stroke.walls)].sort()).toEqual([3, 4, 5])
  expect([...editedCells(stroke.walls, before.walls)].sort()).toEqual([3, 4, 5])
})
