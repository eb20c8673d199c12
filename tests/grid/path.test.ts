import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { rowByRow } from '../../src/grid/text-map'
import {
  type DiagonalRule,
  firstIllegalStep,
  measurePath,
  type Problem,
  problemFromText,
} from '../../src/index'
import { isLegal, type World, type XY } from '../reference/world'
import { problems } from './arbitraries'

const pointIn =
  (width: number) =>
  (cell: number): XY => [cell % width, Math.floor(cell / width)]

function worldOf({ grid, start, goal, diagonal }: Problem): World {
  const { width, height } = grid
  const point = pointIn(width)
  const rows = [...rowByRow(grid)]
  return { width, height, rows, start: point(start), goal: point(goal), rule: diagonal }
}

test('a path is legal as far as each of its steps is', () => {
  const wanderings = fc.array(fc.nat(), { maxLength: 12 })
  fc.assert(
    fc.property(problems, wanderings, (problem, rolls) => {
      const { grid, start } = problem
      const { width, height } = grid
      const point = pointIn(width)
      const world = worldOf(problem)
      const path = [start]
      for (const roll of rolls) {
        const [x, y] = point(path[path.length - 1])
        const nx = Math.min(width - 1, Math.max(0, x - 1 + (roll % 3)))
        const ny = Math.min(height - 1, Math.max(0, y - 1 + (Math.floor(roll / 3) % 3)))
        path.push(ny * width + nx)
      }
      const found = path.findIndex(
        (cell, i) => i > 0 && !isLegal(world, point(path[i - 1]), point(cell)),
      )
      expect(firstIllegalStep(problem, path)).toBe(found)
    }),
    { numRuns: 500 },
  )
})

test('a step to any cell at all is legal only if it leads to a neighbour', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      const { width, height, walls } = problem.grid
      const world = worldOf(problem)
      const cells = Array.from({ length: walls.length + 4 }, (_, i) => i - 2)
      const place = pointIn(width)
      for (const from of cells.filter((cell) => walls[cell] === 0)) {
        const legal = cells.filter((to) => firstIllegalStep(problem, [from, to]) < 0)
        const expected = cells.filter((to) => isLegal(world, place(from), place(to)))
        expect(legal, `from ${from} on ${width} × ${height}`).toEqual(expected)
      }
    }),
  )
})

describe('firstIllegalStep', () => {
  const at = (rule: DiagonalRule) => problemFromText('S.#.\n.#.G\n', rule)

  test('a jump is no step, nor is one over the edge of the map to the next row', () => {
    expect(firstIllegalStep(at('if-at-most-one-obstacle'), [0, 1, 3])).toBe(2)
    expect(firstIllegalStep(at('if-at-most-one-obstacle'), [3, 4])).toBe(1)
    const open = problemFromText('S..\n...\n...\n..G\n')
    expect(firstIllegalStep(open, [6, 2])).toBe(1)
    expect(firstIllegalStep(open, [2, 6])).toBe(1)
  })

  test('staying where one is is no step', () => {
    expect(firstIllegalStep(at('if-at-most-one-obstacle'), [0, 0])).toBe(1)
  })

  test('the rules differ where one obstacle lies beside a diagonal step', () => {
    expect(firstIllegalStep(at('if-at-most-one-obstacle'), [4, 1])).toBe(-1)
    expect(firstIllegalStep(at('only-when-no-obstacles'), [4, 1])).toBe(1)
    // Between (1, 1) and (2, 0) nothing passes under either rule.
    expect(firstIllegalStep(at('if-at-most-one-obstacle'), [1, 6])).toBe(1)
  })

  test('a path of one cell or none has no step', () => {
    expect(firstIllegalStep(at('only-when-no-obstacles'), [0])).toBe(-1)
    expect(firstIllegalStep(at('only-when-no-obstacles'), [])).toBe(-1)
  })
})

describe('measurePath', () => {
  test('counts cells, lengths and turns', () => {
    // (0, 0) E (1, 0) SE (2, 1) SE (3, 2) S (3, 3) on a map 10 wide
    const path = [0, 1, 12, 23, 33]
    const measure = measurePath(10, path)
    expect(measure.cells).toBe(5)
    expect(measure.turns).toBe(2)
    expect(measure.length).toBeCloseTo(1 + Math.SQRT2 + Math.SQRT2 + 1, 12)
  })

  test('a turn to either side is a turn, and so is turning back', () => {
    // On a map 10 wide: E, NE, E, W.
    expect(measurePath(10, [50, 51, 42, 43, 42]).turns).toBe(3)
  })

  test('steps that add as much to the index may lead elsewhere where a map is narrow', () => {
    const wanderings = fc.array(fc.tuple(fc.nat(2), fc.nat(2)), { maxLength: 30 })
    fc.assert(
      fc.property(fc.integer({ min: 2, max: 4 }), wanderings, (width, rolls) => {
        const points: [number, number][] = [[0, 40]]
        for (const [right, down] of rolls) {
          const [x, y] = points[points.length - 1]
          const next = Math.min(width - 1, Math.max(0, x + right - 1))
          if (next !== x || down !== 1) points.push([next, y + down - 1])
        }
        const steps = points.slice(1).map(([x, y], i) => [x - points[i][0], y - points[i][1]])
        const measure = measurePath(
          width,
          points.map(([x, y]) => y * width + x),
        )
        expect(measure.length).toBeCloseTo(
          steps.reduce((sum, [dx, dy]) => sum + Math.hypot(dx, dy), 0),
          9,
        )
        expect(measure.turns).toBe(
          steps.filter((step, i) => i > 0 && `${step}` !== `${steps[i - 1]}`).length,
        )
      }),
    )
  })

  test('of one cell and of none', () => {
    expect(measurePath(10, [5])).toEqual({ cells: 1, length: 0, turns: 0 })
    expect(measurePath(10, [])).toEqual({ cells: 0, length: 0, turns: 0 })
  })
})
