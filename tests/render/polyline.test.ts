import { describe, expect, it } from 'vitest'
import { traceCells } from '../../src/render/layers/polyline'
import { placeMap } from '../../src/render/placement'

const screen = { width: 1000, height: 1000, pixel: 1 }

/** The strokes of a line as lists of cells, on a map whose cells are 10 pixels large. */
function strokes(columns: number, cells: readonly number[], left = 0): number[][] {
  const rows = Math.ceil((Math.max(...cells) + 1) / columns)
  const place = placeMap({ scale: 10, left, top: 0 }, { width: columns, height: rows }, screen)
  const drawn: number[][] = []
  const cellOf = (x: number, y: number) =>
    Math.floor(y / 10) * columns + Math.floor((x - place.left) / 10)
  const pen: Parameters<typeof traceCells>[0] = {
    moveTo: (x, y) => drawn.push([cellOf(x, y)]),
    lineTo: (x, y) => drawn.at(-1)?.push(cellOf(x, y)),
  }
  traceCells(pen, place, cells)
  return drawn
}

describe('traceCells', () => {
  it('draws straight runs as one segment', () => {
    expect(strokes(5, [0, 1, 2, 8, 14, 13, 12])).toEqual([[0, 2, 14, 12]])
  })

  it('keeps a way that goes there and back', () => {
    expect(strokes(5, [0, 1, 2, 1, 0, 5])).toEqual([[0, 2, 0, 5]])
  })

  it('tells directions apart on a map two cells wide', () => {
    expect(strokes(2, [0, 1, 2, 3])).toEqual([[0, 1, 2, 3]])
  })

  it('leaves out what lies beyond the screen', () => {
    // Only columns from 20 on are on the screen; the way comes back to them.
    const there = [25, 24, 23, 22, 21, 20, 19, 18, 17, 16, 15, 14]
    const back = [44, 45, 46, 47, 48, 49, 50]
    expect(strokes(30, [...there, ...back], -200)).toEqual([
      [25, 14],
      [44, 50],
    ])
  })

  it('draws nothing for a single cell', () => {
    expect(strokes(5, [3])).toEqual([])
  })
})
