import { describe, expect, it } from 'vitest'
import { withCells } from '../../src/grid/grid'
import { problemFromText } from '../../src/grid/text-map'
import { CellImage } from '../../src/render/cell-image'
import { pixelOf, rgbOf } from '../../src/render/colour'
import { heatColours } from '../../src/render/heat'
import type { Scene, Sight } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { EVENT, type EventKind } from '../../src/trace/events'
import { Player } from '../../src/trace/player'
import { kindsOf } from '../trace/written'
import { momentOf, sceneOf, tapeOf } from './scenes'

const { cell, obstacle } = themes.dark

function colours(scene: Scene): Uint32Array {
  const image = new CellImage()
  image.update(scene)
  return image.pixels
}

const pixels = (...hex: string[]): number[] => hex.map((colour) => pixelOf(rgbOf(colour)))

/** The image as rows of letters, so that a test can show what it expects. */
function letters(scene: Scene, names: Record<string, string>): string[] {
  const letterOf = new Map(Object.entries(names).map(([letter, hex]) => [pixels(hex)[0], letter]))
  const { width, height } = scene.problem.grid
  const image = colours(scene)
  return Array.from({ length: height }, (_, y) =>
    Array.from({ length: width }, (_, x) => letterOf.get(image[y * width + x]) ?? '?').join(''),
  )
}

describe('the colour of a cell', () => {
  const problem = problemFromText('S.#\n.#.\n..G')

  it('tells free cells and obstacles where there is no plan', () => {
    const names = { '.': cell.free, '#': obstacle.seen }
    expect(letters(sceneOf(problem), names)).toEqual(['..#', '.#.', '...'])
  })

  it('is the theme’s', () => {
    const { cell, obstacle } = themes.light
    const names = { '.': cell.free, '#': obstacle.seen }
    const scene = sceneOf(problem, { theme: themes.light })
    expect(letters(scene, names)).toEqual(['..#', '.#.', '...'])
  })

  it('tells the open and the closed cells of a search', () => {
    const corridor = problemFromText('S......\n#####.#\n....G..')
    const tape = tapeOf(corridor, 'decomposition')
    const names = { '.': cell.free, '#': obstacle.seen, o: cell.open, c: cell.closed }
    const at = (time: number) => letters(sceneOf(corridor, { plan: momentOf(tape, time) }), names)
    expect(at(0)).toEqual(['.......', '#####.#', '.......'])
    // Opened the start, closed it and opened its one neighbour, closed that and opened the next.
    const search = kindsOf(tape).indexOf(EVENT.open)
    expect(at(search)).toEqual(at(0))
    expect(at(search + 3)).toEqual(['cco....', '#####.#', '.......'])
    expect(at(tape.length)[2]).toBe('....coo')
  })

  it('tells what the rover has sensed, what it has felt, and what it does not know', () => {
    const wall = problemFromText('.......\nS..#..G\n.......\n.......\n.......')
    const tape = tapeOf(wall, 'bug1')
    const names = {
      '.': cell.sensed,
      ' ': cell.unsensed,
      '#': obstacle.seen,
      u: obstacle.unsensed,
      f: obstacle.felt,
    }
    const at = (time: number) =>
      letters(sceneOf(wall, { plan: momentOf(tape, time), sensorRange: 1 }), names)
    expect(at(0)).toEqual(['       ', '   u   ', '       ', '       ', '       '])
    const sensedAtStart = firstTime(tape.length, (time) => at(time)[2].startsWith('..'))
    expect(at(sensedAtStart)).toEqual(['..     ', '.. u   ', '..     ', '       ', '       '])
    const end = at(tape.length)
    expect(end[1][3]).toBe('f')
    expect(end[4]).toBe('       ')
  })

  it('tells only what the rover knows, or nothing of it, as it is wanted', () => {
    const walls = problemFromText('.......\nS..#..G\n.......\n.......\n..#.#..')
    const tape = tapeOf(walls, 'bug1')
    const scene = sceneOf(walls, { plan: momentOf(tape), sensorRange: 1 })
    const names = {
      '.': cell.sensed,
      ' ': cell.unsensed,
      w: cell.free,
      '#': obstacle.seen,
      u: obstacle.unsensed,
      f: obstacle.felt,
    }
    const rows = (sight: Sight) => letters({ ...scene, sight }, names)
    expect(rows('both').at(-1)).toBe('  u u  ')
    expect(rows('known').at(-1)).toBe('       ')
    expect(rows('known').slice(0, -1)).toEqual(rows('both').slice(0, -1))
    expect(rows('world')).toEqual(['wwwwwww', 'wwwfwww', 'wwwwwww', 'wwwwwww', 'ww#w#ww'])
  })

  it('shows a planner without a rover the world, however it is looked at', () => {
    const tape = tapeOf(problem, 'decomposition')
    const scene = sceneOf(problem, { plan: momentOf(tape) })
    for (const sight of ['both', 'world', 'known'] as const) {
      expect(colours({ ...scene, sight })).toEqual(colours(scene))
    }
    expect(colours(sceneOf(problem, { sensorRange: 1, sight: 'known' }))).toEqual(
      colours(sceneOf(problem)),
    )
  })

  it('leaves an obstacle an obstacle, whatever the plan says of its cell', () => {
    const open = problemFromText('S...G\n.....')
    const tape = tapeOf(open, 'decomposition')
    const edited = { ...open, grid: withCells(open.grid, [2], true) }
    const scene = sceneOf(edited, { plan: momentOf(tape) })
    expect(colours(scene)[2]).toBe(pixels(obstacle.seen)[0])
  })

  it('knows nothing of a plan for a map of another size', () => {
    const tape = tapeOf(problemFromText('S...G\n.....'), 'decomposition')
    const scene = sceneOf(problem, { plan: momentOf(tape) })
    expect(colours(scene)).toEqual(colours(sceneOf(problem)))
  })

  it('is the heat of the potential if that is shown: least at the goal, more further away', () => {
    const field = problemFromText('S.......G\n....#....')
    const tape = tapeOf(field, 'potential-field')
    const shown = colours(sceneOf(field, { plan: momentOf(tape), showPotential: true }))
    const hidden = colours(sceneOf(field, { plan: momentOf(tape) }))
    const heat = heatColours(themes.dark).map(pixelOf)
    expect(shown[8]).toBe(heat[0])
    expect(heat.indexOf(shown[0])).toBeGreaterThan(heat.indexOf(shown[7]))
    expect(shown[13]).toBe(pixels(obstacle.seen)[0])
    expect(hidden[8]).toBe(pixels(cell.free)[0])
  })
})

describe('fields', () => {
  const problem = problemFromText('S.......G\n....#....')
  const tape = tapeOf(problem, 'potential-field')
  const heat = heatColours(themes.dark).map(pixelOf)
  const at = (time: number) =>
    colours(sceneOf(problem, { plan: momentOf(tape, time), showPotential: true }))
  const lastOf = (kind: EventKind) => kindsOf(tape).lastIndexOf(kind) + 1

  it('come one after the other, each with a range of its own', () => {
    const attraction = at(lastOf(EVENT.attraction))
    expect([attraction[9], attraction[8]]).toEqual([heat[255], heat[0]])
    const repulsion = at(lastOf(EVENT.repulsion))
    expect([repulsion[0], repulsion[8]]).toEqual([heat[0], heat[0]])
    // Below, above and beside the obstacle it is 30, its greatest value.
    expect([repulsion[4], repulsion[12]]).toEqual([heat[255], heat[255]])
    const sum = at(lastOf(EVENT.potential))
    expect([sum[9], sum[8]]).toEqual([heat[255], heat[0]])
  })

  it('leave cells plain that have no value so far, in spite of the field before', () => {
    const first = kindsOf(tape).indexOf(EVENT.repulsion)
    expect(at(first)[9]).toBe(heat[255])
    const [free] = pixels(cell.free)
    expect([...at(first + 2).subarray(0, 4)]).toEqual([heat[0], heat[0], free, free])
  })

  it('are painted cell by cell as they come', () => {
    const image = new CellImage()
    const player = new Player(tape)
    for (let time = 0; time <= tape.length; time++) {
      const plan = { tape, frame: player.moveTo(time) }
      image.update(sceneOf(problem, { plan, showPotential: true }))
      expect(image.pixels).toEqual(at(time))
    }
  })
})

/** The first time at which something holds. */
function firstTime(length: number, holds: (time: number) => boolean): number {
  for (let time = 0; time <= length; time++) if (holds(time)) return time
  throw new Error('It never holds.')
}
