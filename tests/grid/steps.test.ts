import fc from 'fast-check'
import { expect, test } from 'vitest'
import { DX, DY } from '../../src/grid/directions'
import { allLegalSteps } from '../../src/grid/legal-steps'
import { type DiagonalRule, legalSteps, obstaclesAround } from '../../src/grid/steps'
import { rowByRow } from '../../src/grid/text-map'
import { grids, RULES, rules } from './arbitraries'

test('the legal steps out of every neighbourhood, by the two rules as they are written down', () => {
  for (let obstacles = 0; obstacles < 256; obstacles++) {
    const wallAt = (dx: number, dy: number): boolean => {
      for (let d = 0; d < 8; d++)
        if (DX[d] === dx && DY[d] === dy) return (obstacles >> d) % 2 === 1
      throw new Error('no neighbour')
    }
    for (const rule of RULES) {
      const legal = legalSteps(rule, obstacles)
      for (let d = 0; d < 8; d++) {
        const [dx, dy] = [DX[d], DY[d]]
        const beside = dx === 0 || dy === 0 ? [] : [wallAt(dx, 0), wallAt(0, dy)]
        const corner =
          rule === 'if-at-most-one-obstacle'
            ? beside.length > 0 && beside.every(Boolean)
            : beside.some(Boolean)
        expect((legal >> d) % 2 === 1, `${rule} ${obstacles} ${d}`).toBe(!wallAt(dx, dy) && !corner)
      }
    }
  }
})

test('the obstacles around a cell are those of the map, with the border among them', () => {
  fc.assert(
    fc.property(grids, (grid) => {
      const rows = [...rowByRow(grid)]
      const around = Array.from(grid.walls, (_, cell) => {
        const x = cell % grid.width
        const y = (cell - x) / grid.width
        let obstacles = 0
        for (let d = 0; d < 8; d++) if (rows[y + DY[d]]?.[x + DX[d]] !== '.') obstacles |= 1 << d
        return obstacles
      })
      expect(Array.from(grid.walls, (_, cell) => obstaclesAround(grid, cell))).toEqual(around)
    }),
  )
})

test('all legal steps of a map are those of each free cell, and none from an obstacle', () => {
  fc.assert(
    fc.property(grids, rules, (grid, rule) => {
      const one = Array.from(grid.walls, (wall, cell) =>
        wall ? 0 : legalSteps(rule, obstaclesAround(grid, cell)),
      )
      expect(Array.from(allLegalSteps(grid, rule))).toEqual(one)
    }),
  )
})

test.each([
  ['an array', new Uint8Array(1200)],
  ['an array that begins within a word', new Uint8Array(1203).subarray(3)],
  ['an array of shared memory', new Uint8Array(new SharedArrayBuffer(1200))],
  ['a Buffer', Buffer.alloc(1200)],
])('all legal steps are those of the map as it is now, whichever was before, in %s', (_, walls) => {
  const grid = { width: 40, height: 30, walls }
  const one = (rule: DiagonalRule) =>
    Array.from(grid.walls, (wall, cell) =>
      wall ? 0 : legalSteps(rule, obstaclesAround(grid, cell)),
    )
  const cells = fc.integer({ min: 0, max: 1199 })
  // Few cells and many, at the border too, written into the map that was asked about.
  const edits = fc.array(cells, { maxLength: 60 })
  fc.assert(
    fc.property(edits, rules, (list, rule) => {
      const before = allLegalSteps(grid, rule)
      const copy = before.slice()
      for (const cell of list) grid.walls[cell] ^= 1
      expect(Array.from(allLegalSteps(grid, rule))).toEqual(one(rule))
      expect(before).toEqual(copy)
    }),
    { numRuns: 50 },
  )
})
