import { describe, expect, it } from 'vitest'
import { InputError } from '../../src/grid/errors'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { problemFromText } from '../../src/grid/text-map'
import { CellImage } from '../../src/render/cell-image'
import { edgeLines } from '../../src/render/edge-lines'
import { pictureAsSvg } from '../../src/render/export'
import { isKnownObstacle } from '../../src/render/known-obstacles'
import type { Scene } from '../../src/render/scene'
import { MOST_RECTS, svgCells } from '../../src/render/svg-cells'
import { themes } from '../../src/render/theme'
import { advance } from '../../src/trace/fold'
import { type Frame, knownOf } from '../../src/trace/frame'
import { runToEnd } from './run-to-end'
import { momentOf, randomProblem, sceneOf, svgOf, tapeOf } from './scenes'
import { areaOf, elementsOf } from './svg'

/** How many cells of each colour there are in an SVG. */
function cellsByColour(svg: string): Map<string, number> {
  const cells = svg.slice(svg.indexOf('<g id="cells"'), svg.indexOf('</g>') + 4)
  const paths = elementsOf(cells).filter(({ name }) => name === 'path')
  return new Map(
    paths.map(({ attributes }) => [
      attributes.get('fill') ?? '',
      areaOf(attributes.get('d') ?? ''),
    ]),
  )
}

function pixelsOf(scene: Scene): Uint32Array {
  const image = new CellImage()
  image.update(scene)
  return image.pixels
}

describe('a picture as SVG', () => {
  const problem = randomProblem(23, 17, 0.25, 5)
  const obstacles = problem.grid.walls.reduce((sum, wall) => sum + wall, 0)

  it('is a sound document with a size and a title', () => {
    const svg = svgOf(sceneOf(problem))
    const [root, title] = elementsOf(svg)
    expect(root.name).toBe('svg')
    expect(root.attributes.get('xmlns')).toBe('http://www.w3.org/2000/svg')
    expect(root.attributes.get('viewBox')).toBe(`0 0 ${23 * 32 + 16} ${17 * 32 + 16}`)
    expect(title.name).toBe('title')
    expect(svg).toContain('<title>Map of 23 × 17 cells</title>')
  })

  it('has each cell once, in its colour', () => {
    const { cell, obstacle } = themes.light
    const byColour = cellsByColour(svgOf(sceneOf(problem, { theme: themes.light })))
    expect(byColour.get(obstacle.seen)).toBe(obstacles)
    expect(byColour.get(cell.free)).toBe(23 * 17 - obstacles)
    expect(byColour.size).toBe(2)
  })

  it('lays runs of cells where they are on the map', () => {
    const svg = svgOf(sceneOf(problemFromText('S#.##\n####.\n....G')))
    // Two runs in the first row, the second of which does not go on in the next row.
    const runs = 'M1 0h1v1h-1zM3 0h2v1h-2zM0 1h4v1h-4z'
    expect(svg).toContain(`<path fill="${themes.dark.obstacle.seen}" d="${runs}"/>`)
  })

  it.each([
    ['decomposition', 0],
    ['visibility-graph', 0],
    ['probabilistic-roadmap', 0],
    ['potential-field', 0],
    ['bug1', 1],
    ['bug2', 1],
    ['tangent-bug', 2],
  ] as const)('is sound at every stage of a plan: %s', (planner, sensorRange) => {
    const tape = tapeOf(problem, planner)
    const random = randomNumbers(2)
    const marks = { cursor: 3, hovered: 30, showPotential: true, sensorRange }
    for (let i = 0; i < 40; i++) {
      const plan = momentOf(tape, randomInteger(random, tape.length + 1))
      const svg = svgOf(sceneOf(problem, { ...marks, plan }))
      expect(svg).not.toContain('NaN')
      expect(svg).not.toContain('undefined')
      const area = [...cellsByColour(svg).values()].reduce((a, b) => a + b, 0)
      expect(area).toBe(23 * 17)
      expect(elementsOf(svg).length).toBeGreaterThan(5)
    }
  })

  it.each(['decomposition', 'potential-field', 'bug1'])(
    'is of the moment at which it was asked for, though playing goes on meanwhile: %s',
    (planner) => {
      const tape = tapeOf(problem, planner)
      const scene = (time: number) =>
        sceneOf(problem, { plan: momentOf(tape, time), sensorRange: 1, showPotential: true })
      const half = Math.floor(tape.length / 2)
      const asked = scene(half)
      const picture = pictureAsSvg(asked)
      picture.next()
      if (asked.plan) advance(asked.plan.frame, tape, tape.length)
      const { content } = runToEnd(picture)
      expect(content).toBe(svgOf(scene(half)))
      expect(content).not.toBe(svgOf(scene(tape.length)))
    },
  )

  it('is made in parts, each of them soon done', () => {
    const { grid } = randomProblem(600, 300, 0.1, 1)
    const parts = [...pictureAsSvg(sceneOf({ ...problem, grid }))]
    // Tiles of 256 × 256 cells, and rows.
    expect(parts.length).toBeGreaterThan(6 + 300)
  })

  it('draws the path that was found', () => {
    const corridor = problemFromText('S...G\n.....')
    const svg = svgOf(sceneOf(corridor, { plan: momentOf(tapeOf(corridor, 'decomposition')) }))
    const path = elementsOf(svg).find(
      ({ attributes }) => attributes.get('stroke') === themes.dark.path,
    )
    // From the centre of the first cell to that of the fifth, 8 pixels of margin, 32 a cell.
    expect(path?.attributes.get('d')).toBe('M24 24L152 24')
  })

  it('says that vertices or edges are left out, if they are', () => {
    const large = { ...randomProblem(500, 500, 0, 1), goal: 2 }
    const plan = momentOf(tapeOf(large, 'probabilistic-roadmap'))
    const drawn = (changes: Partial<Frame>) => {
      const frame = { ...plan.frame, ...changes }
      const { content, isCrowded } = runToEnd(
        pictureAsSvg(sceneOf(large, { plan: { ...plan, frame } })),
      )
      const shapes = elementsOf(content).filter(({ name }) => name === 'path')
      const { theme } = sceneOf(large)
      const has = (key: string, colour: string) =>
        shapes.some(({ attributes }) => attributes.get(key) === colour)
      return { isCrowded, edges: has('stroke', theme.roadmap), vertices: has('fill', theme.vertex) }
    }
    expect(drawn({})).toEqual({ isCrowded: false, edges: true, vertices: true })
    expect(drawn({ edgesCut: true })).toEqual({ isCrowded: true, edges: true, vertices: true })
    // So many edges of one step each, no two of which lie on a line together.
    const edges = Int32Array.from({ length: 250_000 }, (_, i) => i)
    expect(drawn({ edges })).toEqual({ isCrowded: true, edges: false, vertices: true })
    const vertices = edges.subarray(0, 100_001)
    expect(drawn({ vertices })).toEqual({ isCrowded: true, edges: true, vertices: false })
  })

  it('draws the roadmap: its edges as lines, and a circle on each vertex', () => {
    const plan = momentOf(tapeOf(problem, 'visibility-graph'))
    const elements = elementsOf(svgOf(sceneOf(problem, { plan })))
    const pathOf = (kind: 'fill' | 'stroke', colour: string) =>
      elements.find(({ attributes }) => attributes.get(kind) === colour)?.attributes.get('d') ?? ''
    const { vertices, edges } = plan.frame
    const parts = (path: string) => path.split('M').length - 1
    expect(parts(pathOf('fill', themes.dark.vertex))).toBe(vertices.length)
    const lines = runToEnd(edgeLines(problem.grid.width, problem.grid.height, edges))
    expect(parts(pathOf('stroke', themes.dark.roadmap))).toBe(lines.length / 2)
  })

  it('writes potentials only if they are shown', () => {
    const plan = momentOf(tapeOf(problem, 'potential-field'))
    const texts = (showPotential: boolean) =>
      elementsOf(svgOf(sceneOf(problem, { plan, showPotential }))).filter(
        ({ name }) => name === 'text',
      ).length
    expect(texts(true)).toBe(23 * 17 - obstacles)
    expect(texts(false)).toBe(0)
  })

  it('refuses maps that would make files too large', () => {
    const striped = (columns: number, rows: number) =>
      Uint32Array.from({ length: columns * rows }, (_, i) => i % 2)
    expect(runToEnd(svgCells(striped(MOST_RECTS, 1), MOST_RECTS))).toContain('h1v1')
    expect(() => runToEnd(svgCells(striped(MOST_RECTS + 1, 1), MOST_RECTS + 1))).toThrow(InputError)
    const walls = Uint8Array.from({ length: 701 * 701 }, (_, i) => i % 2)
    const grid = { width: 701, height: 701, walls }
    expect(() => svgOf(sceneOf({ ...problem, grid, start: 0, goal: 2 }))).toThrow(
      'needs more than 200,000 rectangles',
    )
  })
})

describe('the rover’s knowledge', () => {
  const cases = [
    ['bug1', 1],
    ['bug2', 1],
    ['tangent-bug', 2],
  ] as const

  it.each(cases)('tells nothing of obstacles that it does not know: %s', (planner, sensorRange) => {
    const random = randomNumbers(9)
    let differing = 0
    for (let seed = 1; seed <= 10; seed++) {
      const problem = randomProblem(21, 15, 0.2, seed)
      const tape = tapeOf(problem, planner)
      for (let i = 0; i < 6; i++) {
        const plan = momentOf(tape, randomInteger(random, tape.length + 1))
        const scene = sceneOf(problem, { plan, sensorRange, sight: 'known' })
        const { frame } = plan
        const { grid } = problem
        // The same, but unknown cells are free or not by the throw of a coin.
        const walls = grid.walls.map((wall, cell) => {
          if (knownOf(frame, cell) !== 0 || isKnownObstacle(grid.walls, frame, cell)) return wall
          return random() < 0.5 ? 1 : 0
        })
        const other = { ...scene, problem: { ...problem, grid: { ...grid, walls } } }
        expect(pixelsOf(other)).toEqual(pixelsOf(scene))
        expect(svgOf(other)).toBe(svgOf(scene))
        const both = { ...scene, sight: 'both' } as const
        if (svgOf({ ...other, sight: 'both' }) !== svgOf(both)) differing++
      }
    }
    expect(differing).toBeGreaterThan(40)
  })

  it.each(cases)('shows each obstacle that it knows, and no other: %s', (planner, sensorRange) => {
    const problem = randomProblem(21, 15, 0.2, 3)
    const { obstacle } = themes.dark
    const tape = tapeOf(problem, planner)
    for (let time = 0; time <= tape.length; time += 7) {
      const plan = momentOf(tape, time)
      const scene = sceneOf(problem, { plan, sensorRange, sight: 'known' })
      const byColour = cellsByColour(svgOf(scene))
      const seen = [...problem.grid.walls].filter(
        (_, cell) => knownOf(plan.frame, cell) === 2,
      ).length
      const shown = (byColour.get(obstacle.seen) ?? 0) + (byColour.get(obstacle.felt) ?? 0)
      expect(shown).toBe(seen)
      expect(byColour.has(obstacle.unsensed)).toBe(false)
    }
  })
})
