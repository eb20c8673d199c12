import { describe, expect, it } from 'vitest'
import { randomNumbers } from '../../src/grid/random'
import {
  centreX,
  centreY,
  edgeX,
  edgeY,
  inProportion,
  isVisible,
  mayBeSeen,
  placeMap,
} from '../../src/render/placement'

const screen = { width: 400, height: 300, pixel: 2 }

describe('placeMap', () => {
  it('is in device pixels', () => {
    const place = placeMap({ scale: 10, left: 20, top: 5 }, { width: 8, height: 6 }, screen)
    expect([place.cell, place.left, place.top]).toEqual([20, 40, 10])
    expect([centreX(place, 9), centreY(place, 9)]).toEqual([70, 40])
    expect([edgeX(place, 8), edgeY(place, 6)]).toEqual([200, 130])
  })

  it('lets lines and marks grow with very large cells, whatever their bounds', () => {
    const lineAt = (scale: number) =>
      inProportion(
        placeMap({ scale, left: 0, top: 0 }, { width: 8, height: 6 }, screen),
        0.22,
        2,
        9,
      )
    expect([lineAt(10), lineAt(50), lineAt(56)]).toEqual([4.4, 18, 18])
    expect(lineAt(112)).toBe(36)
  })

  it('knows the columns and rows on the screen: no fewer, no more', () => {
    const random = randomNumbers(5)
    const grid = { width: 50, height: 40 }
    for (let i = 0; i < 200; i++) {
      const scale = 1 + 40 * random()
      const view = { scale, left: 300 * (random() - 0.7), top: 300 * (random() - 0.7) }
      const place = placeMap(view, grid, screen)
      for (let x = 0; x < grid.width; x++) {
        const seen = place.left + (x + 1) * place.cell > 0 && place.left + x * place.cell < 400
        expect(x >= place.fromX && x < place.toX).toBe(seen)
      }
      for (let y = 0; y < grid.height; y++) {
        const seen = place.top + (y + 1) * place.cell > 0 && place.top + y * place.cell < 300
        expect(y >= place.fromY && y < place.toY).toBe(seen)
      }
    }
  })

  const grid = { width: 100, height: 100 }
  const cell = (x: number, y: number) => y * 100 + x
  /** Columns 20 to 39 and rows 30 to 44 can be seen. */
  const place = placeMap({ scale: 10, left: -200, top: -300 }, grid, screen)

  it('sees marks that reach onto the screen from up to two cells beside it', () => {
    expect([place.fromX, place.toX, place.fromY, place.toY]).toEqual([20, 40, 30, 45])
    const seenAt = (...cells: readonly (readonly [number, number])[]) =>
      cells.map(([x, y]) => isVisible(place, cell(x, y)))
    expect(seenAt([18, 28], [41, 28], [18, 46], [41, 46])).toEqual([true, true, true, true])
    expect(seenAt([17, 40], [42, 40], [30, 27], [30, 47])).toEqual([false, false, false, false])
  })

  it('sees lines that lie on the screen or touch its edge', () => {
    const seen = (ax: number, ay: number, bx: number, by: number) =>
      mayBeSeen(place, cell(ax, ay), cell(bx, by))
    expect([seen(19, 0, 19, 99), seen(18, 0, 18, 99)]).toEqual([true, false])
    expect([seen(40, 99, 40, 0), seen(41, 99, 41, 0)]).toEqual([true, false])
    expect([seen(0, 29, 99, 29), seen(0, 28, 99, 28)]).toEqual([true, false])
    expect([seen(99, 45, 0, 45), seen(99, 46, 0, 46)]).toEqual([true, false])
    expect(seen(0, 40, 99, 40)).toBe(true)
  })
})
