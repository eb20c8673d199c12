import { expect, it } from 'vitest'
import { isKnownObstacle, knownGrid } from '../../src/render/known-obstacles'
import { placeMap } from '../../src/render/placement'
import { momentOf, randomProblem, tapeOf } from './scenes'

it('knows the obstacles on the screen and beside it as the rover does, and no others', () => {
  const { grid, ...rest } = randomProblem(30, 20, 0.3, 8)
  const { frame } = momentOf(tapeOf({ grid, ...rest }, 'bug1'))
  const view = { scale: 20, left: -100, top: -60 }
  const place = placeMap(view, grid, { width: 240, height: 200, pixel: 1 })
  expect([place.fromX, place.toX, place.fromY, place.toY]).toEqual([5, 17, 3, 13])
  const known = knownGrid(grid, frame, place)
  let obstacles = 0
  for (let y = 0; y < grid.height; y++) {
    for (let x = 0; x < grid.width; x++) {
      const cell = y * grid.width + x
      const isNear = x >= 4 && x <= 17 && y >= 2 && y <= 13
      const isKnown = isKnownObstacle(grid.walls, frame, cell)
      if (isNear) expect(known.walls[cell] === 1).toBe(isKnown)
      else expect(known.walls[cell]).toBe(0)
      obstacles += known.walls[cell]
    }
  }
  expect(obstacles).toBeGreaterThan(0)
  expect(obstacles).toBeLessThan(grid.walls.reduce((sum, wall) => sum + wall, 0))
})
