import fc from 'fast-check'
import { expect, test } from 'vitest'
import { problemToText } from '../../../src/index'
import { freeCount, freePairs, make, pieces, seeds, sizes } from './maps'

test('a perfect maze: every two free cells are joined by exactly one way of straight steps', () => {
  fc.assert(
    fc.property(sizes, seeds, (size, seed) => {
      const problem = make('maze', size, { loops: 0 }, seed)
      expect(pieces(problem)).toBe(1)
      // A connected graph with one edge fewer than vertices is a tree.
      expect(freePairs(problem).length).toBe(freeCount(problem) - 1)
    }),
    { numRuns: 300 },
  )
})

test('its corridors come within one cell of every place', () => {
  fc.assert(
    fc.property(sizes, seeds, (size, seed) => {
      const { grid } = make('maze', size, { loops: 0 }, seed)
      for (let cell = 0; cell < grid.walls.length; cell++) {
        const x = cell % size.width
        const even = cell - (x % 2) - (((cell - x) / size.width) % 2) * size.width
        expect(grid.walls[even]).toBe(0)
      }
    }),
  )
})

test('loops are made by removing a share of the walls, and no corridor gets wider than one cell', () => {
  const size = { width: 101, height: 101 }
  const loopsOf = (loops: number) => {
    const problem = make('maze', size, { loops }, 3)
    expect(pieces(problem)).toBe(1)
    const { width, walls } = problem.grid
    const wide = [...walls.keys()].filter((cell) => {
      const block = [cell, cell + 1, cell + width, cell + width + 1]
      return cell % width < width - 1 && block.every((one) => walls[one] === 0)
    })
    expect(wide).toEqual([])
    return freePairs(problem).length - freeCount(problem) + 1
  }
  // 51 × 51 rooms have 2 × 51 × 50 walls between them, 51 × 51 - 1 of which the maze itself opens.
  const walls = 2 * 51 * 50 - (51 * 51 - 1)
  expect(loopsOf(0)).toBe(0)
  expect(loopsOf(100)).toBe(walls)
  expect(Math.abs(loopsOf(20) / walls - 0.2)).toBeLessThan(0.04)
})

test('mazes of 2 × 2 and of even sides reach to the border', () => {
  expect(problemToText(make('maze', { width: 2, height: 2 }, { loops: 0 }, 1))).toBe('SG\n.#\n')
  const { grid } = make('maze', { width: 8, height: 6 }, { loops: 0 }, 1)
  const free = (cells: number[]) => cells.filter((cell) => !grid.walls[cell]).length
  expect(free([7, 15, 23, 31, 39, 47])).toBe(3)
  expect(free([40, 41, 42, 43, 44, 45, 46, 47])).toBe(4)
})
