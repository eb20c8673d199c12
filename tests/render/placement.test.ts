import { describe, expect, it } from 'vitest'
import { randomNumbers } from '../../src/grid/random'
import { centreX, centreY, edgeX, edgeY, isVisible, placeMap } from '../../src/render/placement'

const screen = { width: 400, height: 300, pixel: 2 }

describe('placeMap', () => {
  it('is in device pixels', () => {
    const place = placeMap({ scale: 10, left: 20, top: 5 }, { width: 8, height: 6 }, screen)
    expect([place.cell, place.left, place.top]).toEqual([20, 40, 10])
    expect([centreX(place, 9), centreY(place, 9)]).toEqual([70, 40])
    expect([edgeX(place, 8), edgeY(place, 6)]).toEqual([200, 130])
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

  it('sees marks that reach onto the screen from a cell beside it', () => {
    const place = placeMap({ scale: 1, left: -10, top: 0 }, { width: 100, height: 100 }, screen)
    expect(isVisible(place, 9)).toBe(true)
    expect(
      isVisible(placeMap({ scale: 1, left: -60, top: 0 }, { width: 100, height: 9 }, screen), 9),
    ).toBe(false)
  })
})
