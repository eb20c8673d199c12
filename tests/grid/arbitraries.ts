import fc from 'fast-check'
import type { DiagonalRule, Grid, Problem } from '../../src/index'

export const RULES: readonly DiagonalRule[] = ['if-at-most-one-obstacle', 'only-when-no-obstacles']

export const rules = fc.constantFrom(...RULES)

/** Maps of 2 × 2 to 9 × 9 with any share of obstacles. */
export const grids: fc.Arbitrary<Grid> = fc
  .tuple(fc.integer({ min: 2, max: 9 }), fc.integer({ min: 2, max: 9 }), fc.nat({ max: 100 }))
  .chain(([width, height, share]) =>
    fc
      .array(fc.nat({ max: 99 }), { minLength: width * height, maxLength: width * height })
      .map((rolls) => ({
        width,
        height,
        walls: Uint8Array.from(rolls, (r) => (r < share ? 1 : 0)),
      })),
  )

/** Problems on such maps; the cells of start and goal are made free. */
export const problems: fc.Arbitrary<Problem> = fc
  .tuple(grids, fc.nat(), fc.nat(), rules)
  .map(([grid, a, b, diagonal]) => {
    const start = a % grid.walls.length
    const goal = b % grid.walls.length
    const walls = grid.walls.slice()
    walls[start] = 0
    walls[goal] = 0
    return { grid: { ...grid, walls }, start, goal, diagonal }
  })

/** Two places on a map of 40 columns and 40 rows. */
export const places = fc.record({ x: fc.nat({ max: 39 }), y: fc.nat({ max: 39 }) })
