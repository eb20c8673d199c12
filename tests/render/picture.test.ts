import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { emptyGrid, withCells } from '../../src/grid/grid'
import { pathStyles } from '../../src/render/path-styles'
import { Picture } from '../../src/render/picture'
import type { Scene } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { EVENT } from '../../src/trace/events'
import { frameAt } from '../../src/trace/fold'
import { Player } from '../../src/trace/player'
import { Tape } from '../../src/trace/tape'
import { kindsOf } from '../trace/written'
import { momentOf, randomProblem, sceneOf, tapeOf } from './scenes'

/** Canvases that draw nothing and count what is asked of them, by the name of their layer. */
const calls = new Map<string, number>()

function fakeCanvas() {
  const dataset: { layer?: string } = {}
  const context = new Proxy<Record<string, unknown>>(
    {},
    {
      get: () => () => {
        const layer = dataset.layer ?? 'image'
        calls.set(layer, (calls.get(layer) ?? 0) + 1)
      },
      set: () => true,
    },
  )
  return {
    dataset,
    style: {},
    setAttribute() {},
    getContext: () => context,
    width: 0,
    height: 0,
  }
}

beforeEach(() => {
  vi.stubGlobal('document', { createElement: fakeCanvas })
  vi.stubGlobal(
    'ImageData',
    class {
      constructor(
        readonly data: Uint8ClampedArray,
        readonly width: number,
      ) {}
    },
  )
})

afterEach(() => vi.unstubAllGlobals())

describe('a picture redraws only what has changed', () => {
  const view = { scale: 12, left: 10, top: 10 }
  const problem = randomProblem(20, 15, 0.1, 4)
  const host = { append() {} } as unknown as HTMLElement

  function pictureOf(scene: Scene) {
    const picture = new Picture(host)
    picture.resize(400, 300, 1)
    picture.draw(scene, view)
    return picture
  }

  /** The layers that were drawn on by `work`. */
  function drawn(work: () => void): string[] {
    calls.clear()
    work()
    return [...calls.keys()].sort()
  }

  it('nothing if nothing has', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    expect(drawn(() => picture.draw({ ...scene }, { ...view }))).toEqual([])
  })

  it('the marks if the cursor moves, or the cell that is asked about', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    expect(drawn(() => picture.draw({ ...scene, cursor: 3 }, view))).toEqual(['marks'])
    expect(drawn(() => picture.draw({ ...scene, cursor: 3, hovered: 7 }, view))).toEqual(['marks'])
  })

  it('the marks while corners are tested and pairs are refused', () => {
    const tape = tapeOf(problem, 'visibility-graph')
    const scene = sceneOf(problem, { plan: momentOf(tape, 0) })
    const picture = pictureOf(scene)
    const at = (time: number) =>
      drawn(() => picture.draw({ ...scene, plan: momentOf(tape, time) }, view))
    for (const kind of [EVENT.test, EVENT.refuse]) {
      const first = kindsOf(tape).indexOf(kind)
      at(first)
      expect(at(first + 1)).toEqual(['marks'])
    }
  })

  it('the marks when the same number of other nodes is found from the same cell', () => {
    const open = randomProblem(20, 15, 0, 1)
    const frame = (nodes: number[]) => {
      const tape = new Tape()
      tape.begin(20, 15)
      tape.write(EVENT.step, 44)
      tape.write(EVENT.scan, 44)
      for (const node of nodes) tape.write(EVENT.node, node)
      return frameAt(tape, tape.length)
    }
    const tape = tapeOf(open, 'tangent-bug')
    const scene = sceneOf(open, { plan: { tape, frame: frame([2, 3]) }, sensorRange: 2 })
    const picture = pictureOf(scene)
    const other = { ...scene, plan: { tape, frame: frame([2, 4]) } }
    expect(drawn(() => picture.draw(other, view))).toEqual(['marks'])
  })

  it('the compared paths if one comes or goes', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    const comparison = [{ path: [0, 1, 2], style: pathStyles[0] }]
    const compared = { ...scene, comparison }
    expect(drawn(() => picture.draw(compared, view))).toEqual(['comparison'])
    expect(drawn(() => picture.draw({ ...compared, comparison: [...comparison] }, view))).toEqual(
      [],
    )
    expect(drawn(() => picture.draw(scene, view))).toEqual(['comparison'])
  })

  it('the cells if one is edited', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    const edited = { ...problem, grid: withCells(problem.grid, [44], !problem.grid.walls[44]) }
    expect(drawn(() => picture.draw({ ...scene, problem: edited }, view))).toEqual([
      'ground',
      'image',
    ])
  })

  it('no tiles of a large map that are not yet painted', () => {
    const picture = pictureOf(sceneOf(problem))
    const large = sceneOf({ ...problem, grid: emptyGrid(1024, 1024) })
    // Each canvas of a tile, as it gets its cells and as it is drawn from its half.
    const tilesInFrame = () => {
      calls.clear()
      let asked = 0
      picture.draw(large, { ...view, scale: 0.25 }, () => asked++ > 0)
      return (calls.get('image') ?? 0) / 2
    }
    expect([tilesInFrame(), tilesInFrame()]).toEqual([1, 1])
  })

  it('the cells when rows of them become vertices', () => {
    const tape = tapeOf(problem, 'decomposition')
    const first = kindsOf(tape).indexOf(EVENT.row)
    const scene = sceneOf(problem, { plan: momentOf(tape, first) })
    const picture = pictureOf(scene)
    const next = { ...scene, plan: momentOf(tape, first + 1) }
    expect(drawn(() => picture.draw(next, view))).toEqual(['ground'])
  })

  it('the same frame again, once it has advanced', () => {
    const player = new Player(tapeOf(problem, 'decomposition'))
    const search = kindsOf(player.tape).indexOf(EVENT.open)
    const plan = { tape: player.tape, frame: player.moveTo(search + 4) }
    const scene = sceneOf(problem, { plan })
    const picture = pictureOf(scene)
    player.moveTo(search + 9)
    expect(drawn(() => picture.draw(scene, view))).toEqual(['ground', 'image'])
    player.moveTo(player.tape.length)
    expect(drawn(() => picture.draw(scene, view))).toContain('plan')
  })

  it('the roadmap while its edges come, and not when the search goes on', () => {
    const tape = tapeOf(problem, 'visibility-graph')
    const lastEdge = kindsOf(tape).lastIndexOf(EVENT.edge)
    const scene = sceneOf(problem, { plan: momentOf(tape, lastEdge - 5) })
    const picture = pictureOf(scene)
    const at = (time: number) =>
      drawn(() => picture.draw({ ...scene, plan: momentOf(tape, time) }, view))
    // Among the marks the latest edge stands out.
    expect(at(lastEdge + 1)).toEqual(['marks', 'roadmap'])
    expect(at(lastEdge + 3)).not.toContain('roadmap')
    expect(at(0)).toContain('roadmap')
  })

  it('no layer on which nothing is or was to be seen', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    const moved = { ...view, left: 11 }
    expect(drawn(() => picture.draw(scene, moved))).toEqual(['ground', 'marks'])
    const plan = momentOf(tapeOf(problem, 'bug2'))
    picture.draw({ ...scene, plan, sensorRange: 1 }, moved)
    expect(drawn(() => picture.draw(scene, moved))).toContain('plan')
    expect(drawn(() => picture.draw(scene, view))).toEqual(['ground', 'marks'])
  })

  it('no vertices while too many are in view, and says so', () => {
    const wide = { start: 0, goal: 1, grid: emptyGrid(200, 200) }
    const tape = new Tape()
    tape.begin(200, 200)
    for (let cell = 0; cell < 200 * 200; cell++) tape.write(EVENT.vertex, cell)
    const scene = sceneOf({ ...problem, ...wide }, { plan: momentOf(tape) })
    const picture = pictureOf(scene)
    expect(picture.isCrowded).toBe(false)
    picture.draw(scene, { scale: 2, left: 0, top: 0 })
    expect(picture.isCrowded).toBe(true)
    expect(drawn(() => picture.draw({ ...scene, plan: null }, view))).toContain('plan')
    expect(picture.isCrowded).toBe(false)
  })

  it('all if the map moves, the theme changes or the screen gets another size', () => {
    const plan = momentOf(tapeOf(problem, 'visibility-graph'))
    const comparison = [{ path: [0, 1, 2], style: pathStyles[0] }]
    const scene = sceneOf(problem, { plan, comparison })
    const picture = pictureOf(scene)
    const all = ['comparison', 'ground', 'marks', 'plan', 'roadmap']
    expect(drawn(() => picture.draw(scene, { ...view, left: 11 }))).toEqual(all)
    const light = { ...scene, theme: themes.light }
    const moved = { ...view, left: 11 }
    expect(drawn(() => picture.draw(light, moved))).toEqual([...all, 'image'].toSorted())
    picture.resize(300, 300, 1)
    expect(drawn(() => picture.draw(light, moved))).toEqual(all)
  })
})
