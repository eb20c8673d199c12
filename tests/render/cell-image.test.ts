import { describe, expect, it } from 'vitest'
import { withCells } from '../../src/grid/grid'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { CellImage } from '../../src/render/cell-image'
import type { Scene, Sight } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { EVENT } from '../../src/trace/events'
import { firstFrame } from '../../src/trace/frame'
import { Player } from '../../src/trace/player'
import { kindsOf } from '../trace/written'
import { momentOf, randomProblem, sceneOf, tapeOf } from './scenes'

const SIGHTS = ['both', 'world', 'known'] as const

/** All of it painted at once. */
function colours(scene: Scene): Uint32Array {
  const image = new CellImage()
  image.update(scene)
  return image.pixels
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
    const search = kindsOf(tape).indexOf(EVENT.open)
    expect(at(0)).toMatchObject([{ left: 0, top: 0, right: 20, bottom: 10 }])
    expect(at(search)).toEqual([])
    expect(at(search + 1)).toMatchObject([{ left: 0, top: 0, right: 1, bottom: 1 }])
    // The start is closed, and its three neighbours are open with that.
    expect(at(search + 2)).toMatchObject([{ left: 0, top: 0, right: 2, bottom: 2 }])
    expect(at(search + 1)).toMatchObject([{ left: 0, top: 0, right: 2, bottom: 2 }])
  })

  it('paints an edit where it was made', () => {
    const problem = randomProblem(20, 10, 0, 3)
    const image = new CellImage()
    image.update(sceneOf(problem))
    const edited = { ...problem, grid: withCells(problem.grid, [25, 47], true) }
    expect(image.update(sceneOf(edited))).toMatchObject([{ left: 5, top: 1, right: 8, bottom: 3 }])
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

describe('a map of many tiles, painted a few of them at a time', () => {
  const WIDTH = 700
  const problem = randomProblem(WIDTH, 300, 0.2, 5)
  const tape = tapeOf(problem, 'decomposition')
  const plan = momentOf(tape)
  const scene = sceneOf(problem, { plan })

  /** Time for so many tiles. */
  const timeFor = (tiles: number) => {
    let left = tiles
    return () => left-- === 0
  }
  const all = () => true

  it('is complete after as many times as that takes, the tiles in view first', () => {
    const image = new CellImage()
    // The two tiles at the right end, of three columns and two rows.
    const isInView = ({ left }: { left: number }) => left === 512
    const first = image.update(scene, { isInView, isTimeUp: timeFor(2) })
    expect(first.map(({ left, top }) => [left, top])).toEqual([
      [512, 0],
      [512, 256],
    ])
    expect(image.isComplete).toBe(false)
    image.update(scene, { isInView, isTimeUp: timeFor(3) })
    expect(image.isComplete).toBe(false)
    expect(image.update(scene, { isInView, isTimeUp: timeFor(3) })).toMatchObject([
      { left: 256, top: 256, right: 512, bottom: 300 },
    ])
    expect(image.isComplete).toBe(true)
    expect(image.pixels).toEqual(colours(scene))
    expect(image.update(scene)).toEqual([])
  })

  it('shows an edit at once while all else is late: a plan that comes, goes or is left behind', () => {
    const image = new CellImage()
    image.update(scene)
    const cells = [0, 300, 699, 290 * WIDTH + 400].map((cell) => cell + 2)
    let edited = problem.grid
    for (const cell of cells) edited = withCells(edited, [cell], edited.walls[cell] === 0)
    const none = { isInView: all, isTimeUp: all }
    for (const next of [
      sceneOf({ ...problem, grid: edited }),
      sceneOf(problem, { plan }),
      sceneOf({ ...problem, grid: edited }, { plan: momentOf(tape, 900) }),
    ]) {
      const boxes = image.update(next, none)
      expect(image.isComplete).toBe(false)
      const now = colours(next)
      for (const cell of cells) expect(image.pixels[cell]).toBe(now[cell])
      const area = boxes.reduce((sum, b) => sum + (b.right - b.left) * (b.bottom - b.top), 0)
      expect(area).toBeLessThanOrEqual(2 * cells.length)
    }
  })

  it('paints another map of the same size a few tiles at a time, and an edit of it at once', () => {
    const image = new CellImage()
    image.update(sceneOf(problem))
    const others = problem.grid.walls.map((wall) => 1 - wall)
    const other = { ...problem, grid: { ...problem.grid, walls: others } }
    const boxes = image.update(sceneOf(other), { isInView: all, isTimeUp: timeFor(2) })
    expect(boxes.map(({ left, top }) => [left, top])).toEqual([
      [0, 0],
      [256, 0],
    ])
    expect(image.isComplete).toBe(false)

    const cell = 290 * WIDTH + 690
    const edited = { ...other, grid: withCells(other.grid, [cell], others[cell] === 0) }
    image.update(sceneOf(edited), { isInView: all, isTimeUp: all })
    const now = colours(sceneOf(edited))
    expect(image.pixels[cell]).toBe(now[cell])
    image.update(sceneOf(edited))
    expect(image.pixels).toEqual(now)
  })

  it('ends with the latest scene, whatever came while it was late', () => {
    const random = randomNumbers(3)
    const player = new Player(tape)
    const image = new CellImage()
    const theme = themes.light
    let { grid } = problem
    let latest = scene
    for (let i = 0; i < 40; i++) {
      const time = player.frame.time + randomInteger(random, 20_000)
      const frame = player.moveTo(random() < 0.2 ? randomInteger(random, tape.length) : time)
      if (random() < 0.5) grid = withCells(grid, [randomInteger(random, 210_000)], random() < 0.5)
      latest = sceneOf(
        { ...problem, grid },
        { theme, plan: random() < 0.2 ? null : { tape, frame } },
      )
      image.update(latest, { isInView: all, isTimeUp: timeFor(randomInteger(random, 3)) })
    }
    image.update(latest)
    expect(image.pixels).toEqual(colours(latest))
  })
})
