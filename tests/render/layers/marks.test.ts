import { describe, expect, it } from 'vitest'
import type { Cell, Point } from '../../../src/grid/grid'
import { drawMarks } from '../../../src/render/drawing'
import { drawHits, drawLeaves } from '../../../src/render/layers/boundary-points'
import { drawCornerTest } from '../../../src/render/layers/corner-test'
import { drawCursor, drawHovered } from '../../../src/render/layers/cursor'
import { drawEnds } from '../../../src/render/layers/ends'
import { drawMLine } from '../../../src/render/layers/m-line'
import { drawEdges, drawVertices } from '../../../src/render/layers/roadmap'
import { drawRoute } from '../../../src/render/layers/route'
import { drawLatestEdge, drawRefusal } from '../../../src/render/layers/tried-edges'
import { randomProblem, sceneOf } from '../scenes'
import { boxOf, type Shape, shapesOf } from './noting-pen'
import { COLUMNS, cellAt, middleOf, place, ROWS, SIDE, theme } from './small-map'

const middleOfBox = (lines: Shape['lines']): Point => {
  const { left, top, right, bottom } = boxOf(lines)
  return { x: (left + right) / 2, y: (top + bottom) / 2 }
}

describe('a roadmap', () => {
  it('has a circle on each vertex', () => {
    const vertices = [0, 9, 47]
    const [{ by, colour, circles }] = shapesOf((pen) => drawVertices(pen, place, theme, vertices))
    expect([by, colour]).toEqual(['fill', theme.vertex])
    expect(circles.map(({ x, y }) => ({ x, y }))).toEqual(vertices.map(middleOf))
  })

  it('has squares instead where there are thousands', () => {
    const many = Array.from({ length: 4001 }, (_, i) => i % (COLUMNS * ROWS))
    const drawn = (count: number) =>
      shapesOf((pen) => drawVertices(pen, place, theme, many.slice(0, count)))[0]
    expect(drawn(4000).circles).toHaveLength(4000)
    const { circles, lines } = drawn(4001)
    expect(circles).toEqual([])
    expect(lines).toHaveLength(4001)
    for (const i of [0, 20, 47]) {
      const { left, top, right, bottom } = boxOf([lines[i]])
      const { x, y } = middleOf(many[i])
      expect([left, top, right - left, bottom - top].every(Number.isInteger)).toBe(true)
      expect(Math.abs((left + right) / 2 - x)).toBeLessThanOrEqual(1)
      expect(Math.abs((top + bottom) / 2 - y)).toBeLessThanOrEqual(1)
    }
  })

  it('has a line from middle to middle for each pair of cells', () => {
    const [{ by, colour, lines }] = shapesOf((pen) => drawEdges(pen, place, theme, [0, 9, 3, 27]))
    expect([by, colour]).toEqual(['stroke', theme.roadmap])
    expect(lines).toEqual([
      [middleOf(0), middleOf(9)],
      [middleOf(3), middleOf(27)],
    ])
  })

  it('shows the latest edge along its simplest path, with both its ends', () => {
    const [from, to] = [cellAt(1, 1), cellAt(5, 3)]
    const [line, ends] = shapesOf((pen) => drawLatestEdge(pen, place, theme, from, to))
    expect(line.lines).toEqual([[from, cellAt(3, 3), to].map(middleOf)])
    expect(ends.circles.map(({ x, y }) => ({ x, y }))).toEqual([from, to].map(middleOf))
  })

  it('shows where a simplest path is refused: a cross there, dashes from there on', () => {
    const refusal = { from: cellAt(1, 1), to: cellAt(5, 3), at: cellAt(3, 3) }
    const shapes = shapesOf((pen) => drawRefusal(pen, place, theme, refusal))
    const strokes = shapes.filter(({ colour }) => colour === theme.failed)
    expect(strokes.map(({ isDashed }) => isDashed)).toEqual([true, false, false])
    const [after, before, cross] = strokes.map(({ lines }) => lines)
    expect(after).toEqual([[cellAt(3, 3), cellAt(5, 3)].map(middleOf)])
    expect(before).toEqual([[cellAt(1, 1), cellAt(3, 3)].map(middleOf)])
    expect(cross.map((line) => middleOfBox([line]))).toEqual([refusal.at, refusal.at].map(middleOf))
  })
})

describe('ways', () => {
  const cells = [0, 1, 2, 11, 20]

  it.each([
    ['a route', drawRoute, theme.path, false],
    ['an m-line', drawMLine, theme.mLine, true],
  ] as const)(
    '%s leads through the middles of its cells, upon a casing',
    (_, draw, own, dashed) => {
      const [casing, line, ...more] = shapesOf((pen) => draw(pen, place, theme, cells))
      expect(more).toEqual([])
      expect([casing.colour, line.colour]).toEqual([theme.casing, own])
      expect(casing.width).toBeGreaterThan(line.width)
      expect(line.lines).toEqual([[0, 2, 20].map(middleOf)])
      expect(line.isDashed).toBe(dashed)
    },
  )

  it.each([drawRoute, drawMLine])(
    'one is drawn for two cells, and none for a single one',
    (draw) => {
      const [, line] = shapesOf((pen) => draw(pen, place, theme, [3, 12]))
      expect(line.lines).toEqual([[3, 12].map(middleOf)])
      expect(shapesOf((pen) => draw(pen, place, theme, [3]))).toEqual([])
    },
  )
})

describe('hit points and leave points', () => {
  const cells = [cellAt(2, 1), cellAt(6, 4)]

  it.each([
    ['hit points point down', drawHits, 1, theme.hit],
    ['leave points point up', drawLeaves, -1, theme.casing],
  ] as const)('%s, and are numbered', (_, draw, down, colour) => {
    const shapes = shapesOf((pen) => draw(pen, place, theme, cells))
    const triangles = shapes.filter(({ by }) => by === 'fill')
    expect(triangles.map((shape) => shape.colour)).toEqual([colour, colour])
    triangles.forEach(({ lines }, i) => {
      const { x, y } = middleOf(cells[i])
      const [tip, left, right, end] = lines[0]
      expect(end).toEqual(tip)
      expect(tip.x).toBe(x)
      expect((tip.y - y) * down).toBeGreaterThan(0)
      expect([left.x + right.x, left.y]).toEqual([2 * x, right.y])
      expect(left.x).toBeLessThan(x)
      expect((left.y - y) * down).toBeLessThan(0)
    })
    const numbers = shapes.filter(({ by }) => by === 'text')
    expect(numbers.map(({ text }) => text)).toEqual(['1', '2'])
    // In the broad part of the triangle.
    for (const [i, { lines }] of numbers.entries()) {
      expect(lines[0][0].x).toBe(middleOf(cells[i]).x)
      expect((lines[0][0].y - middleOf(cells[i]).y) * down).toBeLessThan(0)
    }
  })
})

describe('start and goal', () => {
  const ends = (start: Cell, goal: Cell, rover = -1) => {
    const shapes = shapesOf((pen) => drawEnds(pen, place, theme, { start, goal }, rover))
    const filled = (colour: string) =>
      shapes.find((shape) => shape.by === 'fill' && shape.colour === colour)
    const glyphs = shapes.filter(({ by, colour }) => by === 'fill' && colour === theme.markGlyph)
    return { disc: filled(theme.start), diamond: filled(theme.goal), glyphs }
  }
  const halfWidth = ({ lines }: Shape) => (boxOf(lines).right - boxOf(lines).left) / 2

  it('are a disc and a diamond in their cells', () => {
    const { disc, diamond, glyphs } = ends(9, 30)
    expect(disc?.circles).toMatchObject([middleOf(9)])
    expect(disc?.circles[0].radius).toBeLessThan(SIDE / 2)
    expect(middleOfBox(diamond?.lines ?? [])).toEqual(middleOf(30))
    // A small diamond in the diamond, and a triangle in the disc that points to the right.
    const [inGoal, inStart] = glyphs
    expect(middleOfBox(inGoal.lines)).toEqual(middleOf(30))
    const [tip, upper, lower] = inStart.lines[0]
    expect(tip).toMatchObject({ y: middleOf(9).y })
    expect([upper.x, upper.y + lower.y]).toEqual([lower.x, 2 * middleOf(9).y])
    expect(tip.x).toBeGreaterThan(middleOf(9).x)
    expect(upper.x).toBeLessThan(middleOf(9).x)
    expect(upper.y).toBeLessThan(lower.y)
  })

  it('are larger under the rover', () => {
    const [usual, atStart, atGoal] = [ends(9, 30), ends(9, 30, 9), ends(9, 30, 30)]
    const radius = ({ disc }: typeof usual) => disc?.circles[0].radius ?? 0
    const width = ({ diamond }: typeof usual) => (diamond ? halfWidth(diamond) : 0)
    expect(radius(atStart)).toBeGreaterThan(1.3 * radius(usual))
    expect(width(atGoal)).toBeGreaterThan(1.3 * width(usual))
    expect([radius(atGoal), width(atStart)]).toEqual([radius(usual), width(usual)])
  })

  it('can both be seen in one cell', () => {
    const { disc, diamond } = ends(9, 9)
    if (!disc || !diamond) throw new Error('One of them is missing.')
    expect(disc.circles[0].radius).toBeLessThan(halfWidth(diamond) / 2)
  })
})

describe('the test for a corner', () => {
  const problem = randomProblem(COLUMNS, ROWS, 0, 1)
  // The obstacle, the cell to the left above it, and one of the two beside both.
  const [obstacle, cell, beside] = [cellAt(4, 3), cellAt(3, 2), cellAt(4, 2)]
  const drawn = (walls: readonly Cell[], passed: boolean) => {
    const grid = { ...problem.grid, walls: problem.grid.walls.slice() }
    for (const wall of walls) grid.walls[wall] = 1
    return shapesOf((pen) => drawCornerTest(pen, place, theme, grid, { cell, obstacle, passed }))
  }
  /** Ticks or crosses: the line around all has the same colour, and four corners. */
  const signs = (shapes: readonly Shape[], own: string) =>
    shapes.filter(({ colour, lines }) => colour === own && lines[0].length < 4)

  it('has ticks in three free cells, and a closed line around all four', () => {
    const shapes = drawn([obstacle], true)
    const ticks = signs(shapes, theme.passed)
    expect(ticks).toHaveLength(3)
    for (const { lines } of ticks) {
      const [[from, corner, to]] = lines
      expect(from.x).toBeLessThan(corner.x)
      expect(corner.x).toBeLessThan(to.x)
      expect(corner.y).toBeGreaterThan(from.y)
      expect(to.y).toBeLessThan(from.y)
    }
    const around = shapes[shapes.length - 1]
    expect(around).toMatchObject({ colour: theme.passed, isDashed: false })
    expect(boxOf(around.lines)).toEqual({ left: 120, top: 80, right: 200, bottom: 160 })
  })

  it('has a cross where one is not free, and a dashed line', () => {
    const shapes = drawn([obstacle, beside], false)
    expect(signs(shapes, theme.passed)).toHaveLength(2)
    const [cross, ...more] = signs(shapes, theme.failed)
    expect(more).toEqual([])
    const middles = cross.lines.map((line) => middleOfBox([line]))
    expect(middles).toEqual([beside, beside].map(middleOf))
    expect(shapes[shapes.length - 1]).toMatchObject({ colour: theme.failed, isDashed: true })
  })

  it('outlines the obstacle', () => {
    const outline = drawn([obstacle], true).find(({ colour }) => colour === theme.vertex)
    const { left, top, right, bottom } = boxOf(outline?.lines ?? [])
    expect([(left + right) / 2, (top + bottom) / 2]).toEqual(Object.values(middleOf(obstacle)))
    expect(right - left).toBeLessThan(SIDE)
  })
})

describe('the cells that a person points at', () => {
  const cell = cellAt(3, 2)
  const boxes = (draw: typeof drawCursor) =>
    shapesOf((pen) => draw(pen, place, theme, cell)).map(({ colour, lines }) => ({
      colour,
      ...boxOf(lines),
    }))

  it('are framed: the keyboard’s around it, the pointer’s within', () => {
    const cursor = { left: 119, top: 79, right: 161, bottom: 121 }
    const hovered = { left: 121.5, top: 81.5, right: 158.5, bottom: 118.5 }
    expect(boxes(drawCursor)).toEqual([
      { colour: theme.casing, ...cursor },
      { colour: theme.cursor, ...cursor },
    ])
    expect(boxes(drawHovered)).toEqual([
      { colour: theme.casing, ...hovered },
      { colour: theme.cursor, ...hovered },
    ])
  })

  it('are drawn of the first cell too, and of none', () => {
    const problem = randomProblem(COLUMNS, ROWS, 0, 1)
    const count = (changes: object) =>
      shapesOf((pen) => drawMarks(pen, place, sceneOf(problem, changes))).length
    expect(count({ hovered: 0 }) - count({})).toBe(2)
    expect(count({ cursor: 0 }) - count({})).toBe(2)
  })
})
