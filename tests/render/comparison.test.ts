import { describe, expect, it } from 'vitest'
import { contrast, rgbOf } from '../../src/render/colour'
import { drawComparison, inLane } from '../../src/render/layers/comparison'
import { pathStyles } from '../../src/render/path-styles'
import { placeMap } from '../../src/render/placement'
import { themes } from '../../src/render/theme'
import { shapesOf } from './layers/noting-pen'
import { randomProblem, sceneOf, svgOf } from './scenes'

const problem = randomProblem(9, 9, 0, 1)
const path = [0, 1, 2, 12, 22, 31]

describe('the styles of compared paths', () => {
  it('stand out from free cells and from their casing in both themes', () => {
    for (const theme of [themes.dark, themes.light]) {
      for (const { colour } of pathStyles) {
        for (const ground of [theme.casing, theme.cell.free, theme.cell.closed]) {
          const ratio = contrast(rgbOf(colour[theme.name]), rgbOf(ground))
          expect(ratio, `${colour[theme.name]} on ${ground}`).toBeGreaterThan(3)
        }
      }
    }
  })

  it('differ in colour and in dashes', () => {
    const different = (of: (style: (typeof pathStyles)[number]) => string) =>
      new Set(pathStyles.map(of)).size
    const all = pathStyles.length
    expect(different(({ colour }) => colour.dark)).toBe(all)
    expect(different(({ colour }) => colour.light)).toBe(all)
    expect(different(({ dash }) => dash.join())).toBe(all)
  })

  it('lie in lanes of their own within their cells', () => {
    const place = placeMap({ scale: 20, left: 0, top: 0 }, problem.grid, {
      width: 400,
      height: 400,
      pixel: 1,
    })
    const tops = pathStyles.map(({ lane }) => inLane(place, lane).top)
    expect(new Set(tops).size).toBe(pathStyles.length)
    for (const top of tops) expect(Math.abs(top)).toBeLessThan(10)
  })
})

/** Open and without arcs, as the marks of start and goal are not. */
const POLYLINE = /^<path d="[ML\d. ]+"/

describe('the picture of compared paths', () => {
  const strokes = (svg: string, colour: string) =>
    svg.split('\n').filter((line) => POLYLINE.test(line) && line.includes(`stroke="${colour}"`))

  it('has each in its colour and dashes, through its cells', () => {
    const middle = (pathStyles.length - 1) / 2
    for (const theme of [themes.dark, themes.light]) {
      const comparison = pathStyles.map((style) => ({ path, style }))
      const svg = svgOf(sceneOf(problem, { theme, comparison }))
      for (const { colour, dash, lane } of pathStyles) {
        const [line, ...more] = strokes(svg, colour[theme.name])
        expect(more).toEqual([])
        expect(line.includes('stroke-dasharray')).toBe(dash.length > 0)
        const [, x, y] = (/d="M([\d.]+) ([\d.]+)L/.exec(line) ?? []).map(Number)
        // Cells are 32 pixels wide and begin after a margin of 8.
        expect(Math.abs(x - 24)).toBeLessThan(12)
        expect(y - 24).toBeCloseTo(((lane - middle) / middle) * 0.34 * 32, 1)
      }
    }
  })

  it('has all casings below all lines, and gaps between dashes whatever ends others draw', () => {
    const place = placeMap({ scale: 20, left: 0, top: 0 }, problem.grid, {
      width: 180,
      height: 180,
      pixel: 1,
    })
    const comparison = pathStyles.map((style) => ({ path, style }))
    const shapes = shapesOf((pen) => drawComparison(pen, place, themes.dark, comparison))
    const casings = pathStyles.map(() => ({ colour: themes.dark.casing, isDashed: false }))
    const lines = pathStyles.map(({ colour, dash }) => ({
      colour: colour.dark,
      isDashed: dash.length > 0,
    }))
    expect(shapes).toMatchObject([...casings, ...lines])
  })

  it('has none if none are compared', () => {
    const svg = svgOf(sceneOf(problem))
    for (const { colour } of pathStyles.slice(1)) expect(strokes(svg, colour.dark)).toEqual([])
  })
})
