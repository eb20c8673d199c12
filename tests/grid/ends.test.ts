import fc from 'fast-check'
import { expect, test } from 'vitest'
import { defaultEnds } from '../../src/grid/ends'
import { InputError } from '../../src/index'
import { grids } from './arbitraries'

test('start and goal are the free cells nearest to the middles of the sides', () => {
  fc.assert(
    fc.property(grids, (grid) => {
      const middle = Math.floor((grid.height - 1) / 2)
      const square = (cell: number, x: number) => {
        const column = cell % grid.width
        return (column - x) ** 2 + ((cell - column) / grid.width - middle) ** 2
      }
      const free = Array.from(grid.walls, (_, cell) => cell).filter((cell) => !grid.walls[cell])
      fc.pre(free.length > 0)
      const { start, goal } = defaultEnds(grid)
      expect(free).toContain(start)
      expect(square(start, 0)).toBe(Math.min(...free.map((cell) => square(cell, 0))))
      const others = free.length > 1 ? free.filter((cell) => cell !== start) : free
      expect(others).toContain(goal)
      const right = grid.width - 1
      expect(square(goal, right)).toBe(Math.min(...others.map((cell) => square(cell, right))))
    }),
  )
})

test('the only free cell is both, and without one there is no problem', () => {
  const grid = (...walls: number[]) => ({ width: 2, height: 2, walls: Uint8Array.from(walls) })
  expect(defaultEnds(grid(1, 1, 0, 1))).toEqual({ start: 2, goal: 2 })
  expect(() => defaultEnds(grid(1, 1, 1, 1))).toThrow(InputError)
  expect(() => defaultEnds(grid(1, 1, 1, 1))).toThrow('The map has no free cell.')
})
