import { describe, expect, it } from 'vitest'
import type { Point } from '../../../src/grid/grid'
import { drawMarks } from '../../../src/render/drawing'
import { drawAtSide, drawRail } from '../../../src/render/layers/following'
import { drawRover, drawSensedSquare, headingOf } from '../../../src/render/layers/rover'
import { drawTangentGraph } from '../../../src/render/layers/tangent-graph'
import { drawTarget } from '../../../src/render/layers/target'
import { EVENT } from '../../../src/trace/events'
import { frameAt } from '../../../src/trace/fold'
import { Tape } from '../../../src/trace/tape'
import type { Thinning } from '../../../src/trace/thinning'
import { randomProblem, sceneOf } from '../scenes'
import { boxOf, shapesOf } from './noting-pen'
import { COLUMNS, cellAt, middleOf, place, ROWS, SIDE, theme } from './small-map'

const rover = cellAt(3, 2)
const problem = randomProblem(COLUMNS, ROWS, 0, 1)

/** A place as the rover sees it that looks along `angle`: ahead of it, and to its right. */
function seenFrom(point: Point, angle: number) {
  const [dx, dy] = [point.x - middleOf(rover).x, point.y - middleOf(rover).y]
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
  return { ahead: dx * cos + dy * sin, right: dy * cos - dx * sin }
}

const ANGLES = [0, 1, 2, 3, 4, 5, 6, 7].map((eighth) => (eighth * Math.PI) / 4)

describe('the rover', () => {
  it.each(ANGLES)('points where it goes: %d', (angle) => {
    const shapes = shapesOf((pen) => drawRover(pen, place, theme, rover, angle))
    expect(shapes.map(({ colour }) => colour)).toEqual([theme.casing, theme.rover])
    const [nose, ...others] = shapes[1].lines[0].map((point) => seenFrom(point, angle))
    expect(nose.right).toBeCloseTo(0)
    expect(nose.ahead).toBeGreaterThan(0)
    expect(nose.ahead).toBeLessThan(SIDE / 2)
    // Back to where it began, and all else behind, as far to the left as to the right.
    expect(others.at(-1)).toEqual(nose)
    const [first, notch, last] = others
    expect(Math.max(first.ahead, notch.ahead, last.ahead)).toBeLessThan(0)
    expect(first.right + last.right).toBeCloseTo(0)
    expect(first.right).toBeGreaterThan(0)
  })

  it('goes where its trail leads, and at first to the goal', () => {
    const degrees = (trail: number[], goal: number) =>
      Math.round((headingOf(COLUMNS, trail, goal) * 180) / Math.PI)
    expect(degrees([0, 1], 40)).toBe(0)
    expect(degrees([0, 1, 9], 0)).toBe(90)
    expect(degrees([9, 0], 40)).toBe(-135)
    expect(degrees([9], 11)).toBe(0)
    expect(degrees([9], 1)).toBe(-90)
    expect(degrees([], 1)).toBe(0)
  })

  it('has around it the square that it senses, as far as that is on the map', () => {
    const square = (range: number) => {
      const [area, line] = shapesOf((pen) => drawSensedSquare(pen, place, theme, rover, range))
      expect([area.colour, line.colour]).toEqual([theme.sensorArea, theme.sensor])
      const [outer, inner] = [boxOf(area.lines), boxOf(line.lines)]
      expect([inner.left - outer.left, outer.bottom - inner.bottom]).toEqual([1, 1])
      return [outer.left, outer.top, outer.right, outer.bottom].map((edge) => edge / SIDE)
    }
    expect(square(1)).toEqual([2, 1, 5, 4])
    expect(square(3)).toEqual([0, 0, 7, 6])
    expect(square(50)).toEqual([0, 0, COLUMNS, ROWS])
  })

  it('is joined to where it heads, and that has a ring', () => {
    const target = cellAt(6, 5)
    const [line, ring] = shapesOf((pen) => drawTarget(pen, place, theme, rover, target))
    expect(line.lines).toEqual([[rover, target].map(middleOf)])
    expect([line.isDashed, ring.isDashed]).toEqual([true, false])
    expect(ring.circles).toMatchObject([middleOf(target)])
  })

  it('is joined to the nodes of its tangent graph, but for those off the map', () => {
    const nodes = [cellAt(0, 0), -1, cellAt(5, 4)]
    const inMap = [cellAt(0, 0), cellAt(5, 4)]
    const [casing, lines, , diamonds] = shapesOf((pen) =>
      drawTangentGraph(pen, place, theme, rover, nodes),
    )
    expect(casing.width).toBeGreaterThan(lines.width)
    expect(lines.lines).toEqual(inMap.map((node) => [rover, node].map(middleOf)))
    expect([diamonds.by, diamonds.colour]).toEqual(['fill', theme.sensor])
    const middles = diamonds.lines.map((line) => {
      const { left, top, right, bottom } = boxOf([line])
      return { x: (left + right) / 2, y: (top + bottom) / 2 }
    })
    expect(middles).toEqual(inMap.map(middleOf))
  })
})

describe('a boundary that is followed', () => {
  it('has a frame within the cell that is kept at the side', () => {
    const [casing, frame] = shapesOf((pen) => drawAtSide(pen, place, theme, rover))
    expect([casing.colour, frame.colour]).toEqual([theme.casing, theme.hit])
    const { left, top, right, bottom } = boxOf(frame.lines)
    const { x, y } = middleOf(rover)
    expect([left + right, top + bottom]).toEqual([2 * x, 2 * y])
    expect(right - left).toBeLessThan(SIDE)
    expect(right - left).toBeGreaterThan(SIDE / 2)
  })

  it.each(ANGLES)('has a rail on the side of the obstacle, and where it leads: %d', (angle) => {
    for (const [turn, side] of [
      [0, -1],
      [1, 1],
    ]) {
      const [, rail] = shapesOf((pen) => drawRail(pen, place, theme, rover, angle, turn))
      expect(rail.colour).toBe(theme.hit)
      const [back, front, barb] = rail.lines[0].map((point) => seenFrom(point, angle))
      expect(back.right).toBeCloseTo(front.right)
      expect(front.right * side).toBeGreaterThan(0)
      expect(back.ahead).toBeLessThan(0)
      expect(front.ahead).toBeGreaterThan(0)
      // One barb of an arrow head, towards the rover.
      expect(barb.ahead).toBeGreaterThan(0)
      expect(barb.ahead).toBeLessThan(front.ahead)
      expect(barb.right * side).toBeLessThan(front.right * side)
    }
  })
})

describe('the marks of a moment', () => {
  /** A rover that follows an obstacle, or heads for a target, on a tape like this. */
  const marks = (thinning: Thinning, write: (tape: Tape) => void, start = rover) => {
    const tape = new Tape()
    tape.begin(COLUMNS, ROWS)
    tape.write(EVENT.step, start)
    write(tape)
    const plan = { tape, frame: frameAt(tape, tape.length) }
    tape.thinning = thinning
    return shapesOf((pen) => drawMarks(pen, place, sceneOf(problem, { plan, sensorRange: 1 })))
  }
  const follow = (tape: Tape) => {
    tape.write(EVENT.hit, rover, rover + 1, 1)
    tape.write(EVENT.feel, rover + 1)
  }
  const strokes = (shapes: ReturnType<typeof marks>, own: string) =>
    shapes.filter(({ by, colour }) => by === 'stroke' && colour === own)

  it('have the obstacle at the side and the rail, unless the tape does not tell them', () => {
    expect(strokes(marks('whole', follow), theme.hit)).toHaveLength(2)
    expect(strokes(marks('thinned', follow), theme.hit)).toHaveLength(0)
    const left = (tape: Tape) => {
      follow(tape)
      tape.write(EVENT.leave, rover, -1, 1)
    }
    expect(strokes(marks('whole', left), theme.hit)).toHaveLength(0)
  })

  it('have the start and the goal, at every moment', () => {
    for (const shapes of [marks('whole', follow), marks('thinned', () => {})]) {
      const filled = shapes.filter(({ by }) => by === 'fill').map(({ colour }) => colour)
      expect(filled).toEqual(expect.arrayContaining([theme.start, theme.goal]))
    }
  })

  it('have a target until the rover is there', () => {
    const ringAt = (target: number) =>
      marks('whole', (tape) => tape.write(EVENT.target, target)).some(
        ({ circles, colour }) => colour === theme.sensor && circles.length > 0,
      )
    expect([rover + 3, 0, rover].map(ringAt)).toEqual([true, true, false])
  })

  it('have a rover in the first cell too, with the square that it senses', () => {
    const shapes = marks('whole', () => {}, 0)
    expect(shapes.map(({ colour }) => colour)).toContain(theme.rover)
    expect(shapes.map(({ colour }) => colour)).toContain(theme.sensorArea)
  })
})
