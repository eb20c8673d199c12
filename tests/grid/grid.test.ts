import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import {
  cellName,
  emptyGrid,
  isInside,
  isObstacle,
  pointOf,
  resized,
  withCells,
} from '../../src/grid/grid'
import { rowByRow } from '../../src/grid/text-map'
import { grids } from './arbitraries'

test('an empty map is free everywhere', () => {
  expect([...rowByRow(emptyGrid(3, 2))]).toEqual(['...', '...'])
})

test('inside are exactly the cells of the map, and all outside is obstacle', () => {
  fc.assert(
    fc.property(grids, (grid) => {
      const rows = [...rowByRow(grid)]
      for (let y = -2; y < grid.height + 2; y++) {
        for (let x = -2; x < grid.width + 2; x++) {
          const sign = rows[y]?.[x]
          expect(isInside(grid, x, y)).toBe(sign !== undefined)
          expect(isObstacle(grid, x, y)).toBe(sign !== '.')
        }
      }
    }),
  )
})

test('a cell counts row by row from the top left', () => {
  expect(pointOf(5, 13)).toEqual({ x: 3, y: 2 })
  expect(cellName(5, 13)).toBe('(3, 2)')
})

describe('withCells', () => {
  const grid = { width: 3, height: 2, walls: Uint8Array.of(0, 1, 0, 0, 0, 1) }

  test('changes the cells that are named and no others', () => {
    expect([...rowByRow(withCells(grid, [0, 1, 4], true))]).toEqual(['##.', '.##'])
    expect([...rowByRow(withCells(grid, [1, 2], false))]).toEqual(['...', '..#'])
  })

  test('leaves the given map as it is', () => {
    withCells(grid, [0, 1, 2, 3, 4, 5], true)
    expect([...rowByRow(grid)]).toEqual(['.#.', '..#'])
  })
})

test('a resized map keeps what fits and is free where it is new', () => {
  fc.assert(
    fc.property(
      grids,
      fc.integer({ min: 2, max: 12 }),
      fc.integer({ min: 2, max: 12 }),
      (grid, width, height) => {
        const before = [...rowByRow(grid)]
        const after = [...rowByRow(resized(grid, width, height))]
        expect(after).toHaveLength(height)
        after.forEach((row, y) => {
          expect(row).toBe((before[y] ?? '').slice(0, width).padEnd(width, '.'))
        })
      },
    ),
  )
})
