import { describe, expect, it } from 'vitest'
import { type Cell, withCells } from '../../../src/grid/grid'
import { randomNumbers } from '../../../src/grid/random'
import { heatInks } from '../../../src/render/heat'
import { drawBorder } from '../../../src/render/layers/border'
import { drawFelt } from '../../../src/render/layers/felt'
import { drawLines } from '../../../src/render/layers/lines'
import { drawPotentials } from '../../../src/render/layers/potentials'
import { drawRims } from '../../../src/render/layers/rims'
import { drawRowDots } from '../../../src/render/layers/row-dots'
import { placeMap } from '../../../src/render/placement'
import { EVENT } from '../../../src/trace/events'
import { frameAt } from '../../../src/trace/fold'
import { Tape } from '../../../src/trace/tape'
import { randomProblem } from '../scenes'
import { boxOf, type Circle, shapesOf } from './noting-pen'
import { COLUMNS, cellAt, middleOf, place, placeOn, ROWS, SIDE, theme } from './small-map'

const { grid } = randomProblem(COLUMNS, ROWS, 0.4, 3)
const cells = [...grid.walls.keys()]
const free = cells.filter((cell) => grid.walls[cell] === 0)
/** Of three columns and two rows, the last of them cut off. */
const corner = placeOn(2.5 * SIDE, 1.5 * SIDE)
const isInCorner = (cell: Cell) => cell % COLUMNS < 3 && cell < 2 * COLUMNS

const middles = (of: readonly Cell[]) => of.map(middleOf)
const placesOf = (circles: readonly Circle[]) => circles.map(({ x, y }) => ({ x, y }))

it('a border goes all around the map', () => {
  const [{ by, colour, lines }] = shapesOf((pen) => drawBorder(pen, place, theme))
  expect([by, colour]).toEqual(['fill', theme.border])
  const [right, bottom] = [COLUMNS * SIDE + 1, ROWS * SIDE + 1]
  expect(boxOf(lines)).toEqual({ left: -1, top: -1, right, bottom })
})

/** The same map somewhere else on a screen, with so many device pixels in a CSS pixel. */
const elsewhere = (pixel: number) =>
  placeMap({ scale: SIDE, left: 20, top: 10 }, grid, { width: 2000, height: 2000, pixel })

it.each([
  [2, 2],
  [1, 1],
  [0.4, 1],
])('with %d device pixels in a pixel the border is %d wide', (pixel, width) => {
  const [{ lines }] = shapesOf((pen) => drawBorder(pen, elsewhere(pixel), theme))
  expect(boxOf(lines)).toEqual({
    left: 20 * pixel - width,
    top: 10 * pixel - width,
    right: (20 + COLUMNS * SIDE) * pixel + width,
    bottom: (10 + ROWS * SIDE) * pixel + width,
  })
})

describe('the lines of the grid', () => {
  it('lie between the cells, from end to end of what is seen', () => {
    const [{ colour, lines }] = shapesOf((pen) => drawLines(pen, corner, theme))
    expect(colour).toBe(theme.gridLine)
    expect(lines.map((line) => boxOf([line]))).toEqual([
      { left: 40, top: 0, right: 41, bottom: 80 },
      { left: 80, top: 0, right: 81, bottom: 80 },
      { left: 0, top: 40, right: 120, bottom: 41 },
    ])
  })

  it.each([
    [4, 2],
    [2, 1],
    [1, 1],
    [0.5, 1],
  ])('end with the map: with %d device pixels in a pixel they are %d wide', (pixel, width) => {
    const [{ lines }] = shapesOf((pen) => drawLines(pen, elsewhere(pixel), theme))
    const [left, top] = [20 * pixel, 10 * pixel]
    const [right, bottom] = [left + COLUMNS * SIDE * pixel, top + ROWS * SIDE * pixel]
    const boxes = lines.map((line) => boxOf([line]))
    const x = left + SIDE * pixel
    const y = top + SIDE * pixel
    expect(boxes[0]).toEqual({ left: x, top, right: x + width, bottom })
    expect(boxes[COLUMNS - 1]).toEqual({ left, top: y, right, bottom: y + width })
    expect(boxes).toHaveLength(COLUMNS - 1 + ROWS - 1)
  })

  it('fade in with the size of the cells', () => {
    const alphaAt = (scale: number) => {
      const size = { width: 600, height: 600, pixel: 2 }
      const alphas: number[] = []
      shapesOf((pen) => {
        const fill = pen.fill.bind(pen)
        pen.fill = () => {
          alphas.push(pen.globalAlpha)
          fill()
        }
        drawLines(pen, placeMap({ scale, left: 0, top: 0 }, grid, size), theme)
      })
      return alphas
    }
    expect([5.9, 6, 9, 18, 30].map(alphaAt)).toEqual([[], [1 / 3], [0.5], [1], [1]])
  })
})

describe('the rims of obstacles', () => {
  const colourOf = (cell: Cell) => `colour ${cell % 3}`

  it('are the pixels of obstacles that lie next to free cells, each in its cell’s colour', () => {
    const width = COLUMNS * SIDE
    const painted = new Map<number, string>()
    for (const { by, colour, lines } of shapesOf((pen) => drawRims(pen, place, grid, colourOf))) {
      expect(by).toBe('fill')
      const { left, top, right, bottom } = boxOf(lines)
      for (let y = top; y < bottom; y++) {
        for (let x = left; x < right; x++) painted.set(y * width + x, colour)
      }
    }
    const isFree = (px: number, py: number) => {
      const [x, y] = [Math.floor(px / SIDE), Math.floor(py / SIDE)]
      return x >= 0 && y >= 0 && x < COLUMNS && y < ROWS && grid.walls[cellAt(x, y)] === 0
    }
    const expected = new Map<number, string>()
    for (let py = 0; py < ROWS * SIDE; py++) {
      for (let px = 0; px < width; px++) {
        if (isFree(px, py)) continue
        // The rim is two pixels wide where cells are 40.
        const isNear = [-2, 0, 2].some((dx) => [-2, 0, 2].some((dy) => isFree(px + dx, py + dy)))
        const cell = cellAt(Math.floor(px / SIDE), Math.floor(py / SIDE))
        if (isNear) expected.set(py * width + px, colourOf(cell))
      }
    }
    expect(painted).toEqual(expected)
    expect(painted.size).toBeGreaterThan(1000)
  })

  it('are drawn of what is seen only, and not on small cells', () => {
    const drawn = new Set<string>()
    const note = (cell: Cell) => {
      drawn.add(String(cell))
      return ''
    }
    shapesOf((pen) => drawRims(pen, corner, grid, note))
    expect([...drawn].map(Number).every(isInCorner)).toBe(true)
    const size = { width: 400, height: 400, pixel: 1 }
    const small = placeMap({ scale: 9, left: 0, top: 0 }, grid, size)
    expect(shapesOf((pen) => drawRims(pen, small, grid, colourOf))).toEqual([])
  })
})

describe('the dots of rows that became vertices', () => {
  const dots = (where: typeof place, rows: number) =>
    shapesOf((pen) => drawRowDots(pen, where, theme, grid, rows))

  it('are in each free cell of these rows', () => {
    const [{ by, colour, circles }] = dots(place, 2)
    expect([by, colour]).toEqual(['fill', theme.vertex])
    expect(placesOf(circles)).toEqual(middles(free.filter((cell) => cell < 2 * COLUMNS)))
    expect(dots(place, 0)).toEqual([])
  })

  it('are drawn as far as they are seen', () => {
    expect(placesOf(dots(corner, ROWS)[0].circles)).toEqual(middles(free.filter(isInCorner)))
  })
})

it('obstacles that were felt have a dot, and nothing else has', () => {
  const tape = new Tape()
  tape.begin(COLUMNS, ROWS)
  for (const cell of cells.filter((cell) => cell % 3 !== 0)) tape.write(EVENT.feel, cell)
  const frame = frameAt(tape, tape.length)
  const felt = (where: typeof place) =>
    shapesOf((pen) => drawFelt(pen, where, theme, grid, frame))[0]
  const expected = cells.filter((cell) => grid.walls[cell] === 1 && cell % 3 !== 0)
  expect(felt(place)).toMatchObject({ by: 'fill', colour: theme.feltMark })
  expect(placesOf(felt(place).circles)).toEqual(middles(expected))
  expect(placesOf(felt(corner).circles)).toEqual(middles(expected.filter(isInCorner)))
})

it('potentials are written in free cells that have one, in the ink for their colour', () => {
  const random = randomNumbers(4)
  const steep = { ...theme, heat: ['#000000', '#ffffff'] }
  const field = Float64Array.from(cells, () => Math.floor(90 * random()))
  field[free[3]] = Number.NaN
  field[free[4]] = Number.POSITIVE_INFINITY
  const drawn = (where: typeof place) =>
    shapesOf((pen) => drawPotentials(pen, where, steep, grid, field, { min: 0, max: 90 }))
  const written = free.filter((cell) => Number.isFinite(field[cell]))
  expect(drawn(place).map(({ text }) => text)).toEqual(written.map((cell) => String(field[cell])))
  expect(drawn(place).map(({ lines }) => lines[0][0])).toEqual(middles(written))
  const inks = heatInks(steep)
  const levels = written.map((cell) => Math.round(Math.sqrt(field[cell] / 90) * 255))
  expect(drawn(place).map(({ colour }) => colour)).toEqual(levels.map((level) => inks[level]))
  expect([inks[0], inks[255]]).toEqual([theme.ink.light, theme.ink.dark])
  expect(drawn(corner)).toHaveLength(written.filter(isInCorner).length)
})

it('cells that were edited count as they are now', () => {
  const edited = withCells(grid, free, true)
  expect(shapesOf((pen) => drawRims(pen, place, edited, () => ''))).toEqual([])
})
