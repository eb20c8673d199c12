import { describe, expect, it } from 'vitest'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import {
  cellAt,
  cellRect,
  fitView,
  keepOnScreen,
  panBy,
  pointAt,
  scaleLimits,
  zoomAt,
} from '../../src/render/view'

const grid = { width: 6, height: 4 }
const view = { scale: 10, left: 100, top: 50 }
const screen = { width: 800, height: 600 }

describe('cellAt', () => {
  it('finds the cell under a place, up to its edges', () => {
    expect(cellAt(view, grid, 100, 50)).toBe(0)
    expect(cellAt(view, grid, 109.9, 59.9)).toBe(0)
    expect(cellAt(view, grid, 110, 50)).toBe(1)
    expect(cellAt(view, grid, 100, 60)).toBe(6)
    expect(cellAt(view, grid, 159.9, 89.9)).toBe(23)
  })

  it('is -1 outside the map, on each side', () => {
    expect(cellAt(view, grid, 99.9, 60)).toBe(-1)
    expect(cellAt(view, grid, 160, 60)).toBe(-1)
    expect(cellAt(view, grid, 120, 49.9)).toBe(-1)
    expect(cellAt(view, grid, 120, 90)).toBe(-1)
  })

  it('finds every cell at its own centre', () => {
    for (let cell = 0; cell < 24; cell++) {
      const { left, top, width, height } = cellRect(view, grid, cell)
      expect(cellAt(view, grid, left + width / 2, top + height / 2)).toBe(cell)
    }
  })
})

it('places the rectangle of a cell', () => {
  expect(cellRect(view, grid, 8)).toEqual({ left: 120, top: 60, width: 10, height: 10 })
})

it('tells places beyond the map in fractions of cells', () => {
  expect(pointAt(view, 95, 75)).toEqual({ x: -0.5, y: 2.5 })
})

describe('zoomAt', () => {
  it('keeps the place of the map under the pointer', () => {
    const random = randomNumbers(1)
    for (let i = 0; i < 200; i++) {
      const px = random() * 800
      const py = random() * 600
      const before = pointAt(view, px, py)
      const zoomed = zoomAt(view, 0.2 + 4 * random(), px, py, { width: 60, height: 40 })
      const after = pointAt(zoomed, px, py)
      expect(after.x).toBeCloseTo(before.x, 9)
      expect(after.y).toBeCloseTo(before.y, 9)
    }
  })

  it('stops at the limits and there leaves the map where it is', () => {
    const { min, max } = scaleLimits(grid)
    const large = zoomAt(view, 1000, 130, 70, grid)
    expect(large.scale).toBe(max)
    expect(zoomAt(large, 2, 300, 10, grid)).toEqual(large)
    expect(zoomAt(view, 1e-6, 130, 70, grid).scale).toBe(min)
  })

  it('lets the largest map be seen whole on a phone, and small maps be large', () => {
    expect(scaleLimits({ width: 2048, height: 2048 }).min * 2048).toBeLessThan(390)
    expect(scaleLimits({ width: 2, height: 2 }).min).toBeLessThan(scaleLimits(grid).max)
  })
})

describe('panBy', () => {
  it('moves the map', () => {
    expect(panBy(view, 30, -20, grid, screen)).toEqual({ scale: 10, left: 130, top: 30 })
  })

  it('never loses the map, however far and from whichever view', () => {
    const random = randomNumbers(2)
    for (let i = 0; i < 300; i++) {
      const size = { width: 2 + randomInteger(random, 99), height: 2 + randomInteger(random, 99) }
      const scale = 0.5 + 60 * random()
      const far = () => (random() - 0.5) * 20_000
      const { left, top } = panBy({ scale, left: 0, top: 0 }, far(), far(), size, screen)
      const shownX = Math.min(800, left + size.width * scale) - Math.max(0, left)
      const shownY = Math.min(600, top + size.height * scale) - Math.max(0, top)
      expect(shownX).toBeGreaterThan(Math.min(48, size.width * scale) - 1e-6)
      expect(shownY).toBeGreaterThan(Math.min(48, size.height * scale) - 1e-6)
    }
  })

  it('leaves a map alone that is on the screen', () => {
    expect(keepOnScreen(view, grid, screen)).toEqual(view)
  })
})

describe('fitView', () => {
  it('shows the whole map in the middle of the free rectangle', () => {
    const rect = { left: 300, top: 40, width: 700, height: 500 }
    for (const size of [grid, { width: 60, height: 40 }, { width: 3, height: 50 }]) {
      const { scale, left, top } = fitView(size, rect)
      expect(left).toBeGreaterThanOrEqual(300)
      expect(top).toBeGreaterThanOrEqual(40)
      expect(left + size.width * scale).toBeLessThanOrEqual(1000)
      expect(top + size.height * scale).toBeLessThanOrEqual(540)
      expect(Math.abs(left + (size.width * scale) / 2 - 650)).toBeLessThanOrEqual(0.5)
      expect(Math.abs(top + (size.height * scale) / 2 - 290)).toBeLessThanOrEqual(0.5)
    }
  })

  it.each([
    ['wide', { width: 400, height: 100 }, 'left', 700],
    ['high', { width: 100, height: 400 }, 'top', 500],
  ] as const)('leaves 16 pixels on each side of a %s map', (_, size, side, room) => {
    const view = fitView(size, { left: 0, top: 0, width: 700, height: 500 })
    expect(Math.abs(view[side] - 16)).toBeLessThanOrEqual(0.5)
    expect(400 * view.scale).toBeCloseTo(room - 32)
  })

  it('gives large cells whole pixels, and as many as there is room for', () => {
    const { scale } = fitView(
      { width: 60, height: 40 },
      { left: 0, top: 0, width: 700, height: 900 },
    )
    expect(scale).toBe(11)
  })

  it.each([
    ['keeps cells at 56 pixels on a screen of a usual size', 1200, 800, 10, 8, 56],
    ['fits a small map on a large screen into the room', 3200, 2000, 20, 15, 131],
    ['makes cells no larger than 15 of them would be', 3200, 2000, 3, 2, 131],
  ] as const)('%s', (_, width, height, columns, rows, side) => {
    const rect = { left: 0, top: 0, width, height }
    const size = { width: columns, height: rows }
    const view = fitView(size, rect)
    expect(view.scale).toBe(side)
    expect(zoomAt(view, 1, 0, 0, size)).toEqual(view)
  })

  it('shrinks the cells of a large map below a pixel', () => {
    const size = { width: 2048, height: 2048 }
    const { scale, left, top } = fitView(size, { left: 0, top: 0, width: 390, height: 844 })
    expect(left).toBeGreaterThan(0)
    expect(left + 2048 * scale).toBeLessThan(390)
    expect(top + 2048 * scale).toBeLessThan(844)
  })

  it('makes do with a rectangle that has no room', () => {
    const { scale } = fitView(grid, { left: 10, top: 10, width: 0, height: 5 })
    expect(scale).toBe(scaleLimits(grid).min)
  })
})
