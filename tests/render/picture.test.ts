import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { withCells } from '../../src/grid/grid'
import { Picture } from '../../src/render/picture'
import type { Scene } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { EVENT } from '../../src/trace/events'
import { Player } from '../../src/trace/player'
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
    remove() {},
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

  it('the marks if the cursor moves', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    expect(drawn(() => picture.draw({ ...scene, cursor: 3 }, view))).toEqual(['marks'])
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

  it('the same frame again, once it has advanced', () => {
    const player = new Player(tapeOf(problem, 'decomposition'))
    const scene = sceneOf(problem, { plan: { tape: player.tape, frame: player.moveTo(4) } })
    const picture = pictureOf(scene)
    player.moveTo(9)
    expect(drawn(() => picture.draw(scene, view))).toEqual(['ground', 'image'])
    player.moveTo(player.tape.length)
    expect(drawn(() => picture.draw(scene, view))).toContain('plan')
  })

  it('the roadmap while its edges come, and not when the search goes on', () => {
    const tape = tapeOf(problem, 'visibility-graph')
    const { kinds, length } = tape
    const lastEdge = kinds.subarray(0, length).lastIndexOf(EVENT.edge)
    const scene = sceneOf(problem, { plan: momentOf(tape, lastEdge - 5) })
    const picture = pictureOf(scene)
    const at = (time: number) =>
      drawn(() => picture.draw({ ...scene, plan: momentOf(tape, time) }, view))
    expect(at(lastEdge + 1)).toEqual(['roadmap'])
    expect(at(lastEdge + 3)).not.toContain('roadmap')
    expect(at(0)).toContain('roadmap')
  })

  it('all if the map moves, the theme changes or the screen gets another size', () => {
    const scene = sceneOf(problem)
    const picture = pictureOf(scene)
    const all = ['ground', 'marks', 'plan', 'roadmap']
    expect(drawn(() => picture.draw(scene, { ...view, left: 11 }))).toEqual(all)
    const light = { ...scene, theme: themes.light }
    const moved = { ...view, left: 11 }
    expect(drawn(() => picture.draw(light, moved))).toEqual(['ground', 'image', ...all.slice(1)])
    picture.resize(300, 300, 1)
    expect(drawn(() => picture.draw(light, moved))).toEqual(all)
  })
})
