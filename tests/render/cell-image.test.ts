import { describe, expect, it } from 'vitest'
import { withCells } from '../../src/grid/grid'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { problemFromText } from '../../src/grid/text-map'
import { CellImage } from '../../src/render/cell-image'
import { pixelOf, rgbOf } from '../../src/render/colour'
import { heatColours } from '../../src/render/heat'
import type { Scene, Sight } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { EVENT, type EventKind } from '../../src/trace/events'
import { firstFrame } from '../../src/trace/frame'
import { Player } from '../../src/trace/player'
import { momentOf, randomProblem, sceneOf, tapeOf } from './scenes'

const { cell, obstacle } = themes.dark
const SIGHTS = ['both', 'world', 'known'] as const

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
    // Opened the start, closed it, opened its one neighbour, closed that, opened the next.
    const search = tape.kinds.indexOf(EVENT.open)
    expect(at(search)).toEqual(at(0))
    expect(at(search + 5)).toEqual(['cco....', '#####.#', '.......'])
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
  const lastOf = (kind: EventKind) => tape.kinds.lastIndexOf(kind) + 1

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
    const first = tape.kinds.indexOf(EVENT.repulsion)
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

describe('painting only what is new', () => {
  const cases = [
    ['decomposition', 0, false],
    ['visibility-graph', 0, false],
    ['probabilistic-roadmap', 0, false],
    ['potential-field', 0, true],
    ['potential-field-memory', 0, true],
    ['bug1', 1, false],
    ['tangent-bug', 2, false],
    ['bug2', 1, false],
  ] as const

  it.each(cases)(
    'gives the same image as painting all: %s',
    (planner, sensorRange, showPotential) => {
      const random = randomNumbers(7)
      const problem = randomProblem(23, 17, 0.2, 11)
      const player = new Player(tapeOf(problem, planner))
      const { tape } = player
      const image = new CellImage()
      let { grid } = problem
      let sight: Sight = 'both'
      for (let i = 0; i < 60; i++) {
        const time = randomInteger(random, tape.length + 1)
        const frame = player.moveTo(time)
        if (random() < 0.4) {
          const edited = [randomInteger(random, 23 * 17), randomInteger(random, 23 * 17)]
          grid = withCells(grid, edited, random() < 0.5)
        }
        if (random() < 0.2) sight = SIGHTS[randomInteger(random, SIGHTS.length)]
        const theme = random() < 0.1 ? themes.light : themes.dark
        const scene = sceneOf(
          { ...problem, grid },
          {
            theme,
            plan: random() < 0.1 ? null : { tape, frame },
            sensorRange,
            sight,
            showPotential,
          },
        )
        image.update(scene)
        expect(image.pixels).toEqual(colours(scene))
      }
    },
  )

  it('says which cells it painted, and nothing if none', () => {
    const problem = randomProblem(20, 10, 0, 3)
    const tape = tapeOf(problem, 'decomposition')
    const player = new Player(tape)
    const image = new CellImage()
    const at = (time: number) => {
      const frame = player.moveTo(time)
      return image.update(sceneOf(problem, { plan: { tape, frame } }))
    }
    const search = tape.kinds.indexOf(EVENT.open)
    expect(at(0)).toEqual({ left: 0, top: 0, right: 20, bottom: 10 })
    expect(at(search)).toBeNull()
    expect(at(search + 2)).toEqual({ left: 0, top: 0, right: 1, bottom: 1 })
    const third = tape.cells[search + 2]
    const [x, y] = [third % 20, Math.floor(third / 20)]
    expect(at(search + 3)).toEqual({ left: x, top: y, right: x + 1, bottom: y + 1 })
    expect(at(search + 1)).toEqual({ left: 0, top: 0, right: 20, bottom: 10 })
  })

  it('paints an edit where it was made', () => {
    const problem = randomProblem(20, 10, 0, 3)
    const image = new CellImage()
    image.update(sceneOf(problem))
    const edited = { ...problem, grid: withCells(problem.grid, [25, 47], true) }
    expect(image.update(sceneOf(edited))).toEqual({ left: 5, top: 1, right: 8, bottom: 3 })
    expect(image.pixels).toEqual(colours(sceneOf(edited)))
  })

  it('paints all when the map gets another size, or another plan of the same length', () => {
    const small = randomProblem(6, 5, 0.2, 1)
    const large = randomProblem(9, 5, 0.2, 1)
    const image = new CellImage()
    image.update(sceneOf(small))
    image.update(sceneOf(large))
    expect(image.pixels).toEqual(colours(sceneOf(large)))
    const late = tapeOf(large, 'decomposition')
    image.update(sceneOf(large, { plan: momentOf(late) }))
    const other = tapeOf(large, 'decomposition')
    const scene = sceneOf(large, { plan: { tape: other, frame: firstFrame(other) } })
    image.update(scene)
    expect(image.pixels).toEqual(colours(scene))
  })
})
