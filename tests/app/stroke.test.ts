import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { gripAt, lineOfCells, paint } from '../../src/app/tools/stroke'
import { emptyGrid, isInside, pointOf } from '../../src/grid/grid'
import { problemFromText } from '../../src/grid/text-map'

const grid = emptyGrid(30, 20)
const places = fc.record({
  x: fc.integer({ min: -40, max: 70 }),
  y: fc.integer({ min: -40, max: 60 }),
})

describe('the cells between two places of the pointer', () => {
  it('have no hole, go straight, and lie on the map', () => {
    fc.assert(
      fc.property(places, places, (from, to) => {
        const cells = lineOfCells(grid, from, to).map((cell) => pointOf(grid.width, cell))
        for (const { x, y } of cells) expect(isInside(grid, x, y)).toBe(true)
        cells.slice(1).forEach(({ x, y }, i) => {
          const steps = Math.max(Math.abs(x - cells[i].x), Math.abs(y - cells[i].y))
          expect(steps).toBe(1)
        })
        const [dx, dy] = [to.x - from.x, to.y - from.y]
        for (const { x, y } of cells) {
          const beside = Math.abs((x - from.x) * dy - (y - from.y) * dx)
          expect(beside).toBeLessThanOrEqual(Math.max(Math.abs(dx), Math.abs(dy)) / 2)
        }
      }),
    )
  })

  it('include both ends where they are on the map', () => {
    expect(lineOfCells(grid, { x: 2, y: 1 }, { x: 2, y: 1 })).toEqual([32])
    expect(lineOfCells(grid, { x: 0, y: 0 }, { x: 3, y: 1 })).toEqual([0, 1, 32, 33])
  })
})

describe('painting', () => {
  const problem = problemFromText('S.#\n..G')

  it('changes only what is not so yet, and never start or goal', () => {
    const { grid: drawn, changed } = paint(problem, [0, 1, 1, 2, 5], true)
    expect(changed).toEqual([1])
    expect([...drawn.walls]).toEqual([0, 1, 1, 0, 0, 0])
    expect([...problem.grid.walls]).toEqual([0, 0, 1, 0, 0, 0])
  })

  it('gives back the same map if nothing changes', () => {
    expect(paint(problem, [0, 2, 5], true).grid).toBe(problem.grid)
    expect(paint(problem, [0, 1], false).grid).toBe(problem.grid)
  })

  it('erases', () => {
    expect([...paint(problem, [1, 2], false).grid.walls]).toEqual([0, 0, 0, 0, 0, 0])
  })
})

it('a press takes hold of what is there', () => {
  const problem = problemFromText('S.#\n..G')
  const grips = [0, 1, 2, 5, -1].map((cell) => gripAt(problem, cell))
  expect(grips).toEqual(['start', 'free', 'obstacle', 'goal', 'outside'])
  expect(gripAt({ ...problem, start: 5 }, 5)).toBe('goal')
})
