import { describe, expect, it } from 'vitest'
import { BLOCK, BlockIndex } from '../../src/render/block-index'
import { CELLS, COLUMNS, ROWS, randomCells } from './indexed-map'

describe('blocks of cells', () => {
  const box = { left: 70, top: 10, right: 200, bottom: 130 }
  const isIn = (cell: number, margin: number) => {
    const [x, y] = [cell % COLUMNS, Math.floor(cell / COLUMNS)]
    const inColumns = x >= box.left - margin && x < box.right + margin
    return inColumns && y >= box.top - margin && y < box.bottom + margin
  }

  it('lead to all that lies in a box, and to nothing far from it', () => {
    const cells = randomCells(5000)
    const index = new BlockIndex(COLUMNS, ROWS)
    for (const cell of cells) index.add(cell)
    const visited: number[] = []
    index.visit(box, (i) => visited.push(i))
    expect(new Set(visited).size).toBe(visited.length)
    const inBox = [...cells.keys()].filter((i) => isIn(cells[i], 0))
    expect(visited).toEqual(expect.arrayContaining(inBox))
    expect(visited.every((i) => isIn(cells[i], BLOCK))).toBe(true)
  })

  it('know how many things lie in a box of whole blocks, and about how many in any', () => {
    const index = new BlockIndex(COLUMNS, ROWS)
    for (let cell = 0; cell < CELLS; cell++) index.add(cell)
    expect(index.estimate({ left: 64, top: 0, right: 192, bottom: 64 })).toBe(128 * 64)
    expect(index.estimate({ left: 10, top: 20, right: 30, bottom: 50 })).toBe(20 * 30)
    expect(
      index.estimate({ left: -20, top: -9, right: COLUMNS, bottom: ROWS }),
    ).toBeLessThanOrEqual(CELLS)
    expect(index.estimate({ left: -9, top: -9, right: 999, bottom: 999 })).toBe(CELLS)
  })
})
