import { describe, expect, it } from 'vitest'
import { isKnownObstacle, knownGrid } from '../../src/render/known-obstacles'
import { placeMap } from '../../src/render/placement'
import { EVENT } from '../../src/trace/events'
import { frameAt } from '../../src/trace/fold'
import { Tape } from '../../src/trace/tape'
import { randomProblem } from './scenes'

const { grid } = randomProblem(30, 20, 0.3, 8)

/** Two of three cells were sensed, and of the others every other one was felt. */
const tape = new Tape()
tape.begin(30, 20)
grid.walls.forEach((wall, cell) => {
  if (cell % 3 !== 0) tape.write(EVENT.sense, cell, wall)
  else if (cell % 2 === 0 && wall) tape.write(EVENT.feel, cell)
})
const frame = frameAt(tape, tape.length)

describe('the map as the rover knows it', () => {
  it('has the obstacles that were sensed or felt, and no others', () => {
    grid.walls.forEach((wall, cell) => {
      const isKnown = wall === 1 && (cell % 3 !== 0 || cell % 2 === 0)
      expect(isKnownObstacle(grid.walls, frame, cell)).toBe(isKnown)
    })
  })

  it.each([
    ['in the middle', { scale: 20, left: -100, top: -60 }, [5, 17, 3, 13]],
    ['at its top left', { scale: 20, left: 40, top: 0 }, [0, 10, 0, 10]],
    ['at its bottom right', { scale: 20, left: -400, top: -240 }, [20, 30, 12, 20]],
  ] as const)('is that of the screen and of one cell beside it: %s', (_, view, seen) => {
    const place = placeMap(view, grid, { width: 240, height: 200, pixel: 1 })
    const [fromX, toX, fromY, toY] = seen
    expect([place.fromX, place.toX, place.fromY, place.toY]).toEqual(seen)
    const known = knownGrid(grid, frame, place)
    const expected = grid.walls.map((_, cell) => {
      const [x, y] = [cell % 30, Math.floor(cell / 30)]
      const isNear = x >= fromX - 1 && x <= toX && y >= fromY - 1 && y <= toY
      return isNear && isKnownObstacle(grid.walls, frame, cell) ? 1 : 0
    })
    expect(known).toEqual({ ...grid, walls: expected })
  })
})
