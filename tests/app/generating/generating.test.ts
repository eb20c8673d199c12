import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { MISSING_PART } from '../../../src/app/fetched-part'
import type { MapAnswer } from '../../../src/app/files/map-worker'
import { generatingFor } from '../../../src/app/generating/generating'
import { makeMap, type WantedMap } from '../../../src/app/generating/wanted-map'
import { dismiss } from '../../../src/app/state/messages'
import { withDiagonal, withGrid } from '../../../src/app/state/setup'
import type { State } from '../../../src/app/state/state'
import { createStore, type Store } from '../../../src/app/state/store'
import { cancel, change, edit, undo } from '../../../src/app/state/transitions'
import { generators } from '../../../src/grid/generators'
import { withCells } from '../../../src/grid/grid'
import { FakeWorker } from '../fake-worker'
import { stateFrom } from '../setups'

const small = { generatorId: 'maze', size: { width: 256, height: 256 }, params: {}, seed: 7 }
const large = { ...small, size: { width: 257, height: 256 } }
const WORDS = 'A maze.'
const CHANGED = 'No map was generated, because the map on screen was changed meanwhile.'

class GeneratingWorker extends FakeWorker<WantedMap, MapAnswer> {
  async finish(): Promise<void> {
    this.say({ kind: 'made', problem: makeMap(this.questions[0]), notes: [] })
    await settled()
  }
}

let store: Store<State>
let workers: GeneratingWorker[]
let generate: (wanted: WantedMap, words: string) => void

const settled = () => new Promise((resolve) => setTimeout(resolve))
const told = () => store.state.messages.map(({ kind, text }) => [kind, text])
const drawnOn = (state: State) =>
  withGrid(state.setup, withCells(state.setup.problem.grid, [5], true))
const wallsOf = ({ generatorId, size, params, seed }: WantedMap) =>
  generators
    .find(({ id }) => id === generatorId)
    ?.generate(size, params, seed, 'if-at-most-one-obstacle').grid.walls

beforeEach(() => {
  workers = []
  store = createStore(stateFrom('S...\n....\n...G'))
  generate = generatingFor(store, () => {
    const made = new GeneratingWorker()
    workers.push(made)
    return made
  })
})

afterEach(() => {
  vi.useRealTimers()
})

describe('generating a map', () => {
  it('a small one is there at once', () => {
    generate(small, WORDS)
    expect(store.state.setup.problem.grid.walls).toEqual(wallsOf(small))
    expect(store.state.said.text).toBe(WORDS)
    expect(workers).toEqual([])
  })

  it('a large one comes from a worker that is ended then; undo leads back', async () => {
    const before = store.state.setup
    generate(large, WORDS)
    expect(store.state.setup).toBe(before)
    await workers[0].finish()
    expect(store.state.setup.problem.grid.walls).toEqual(wallsOf(large))
    expect(store.state.said.text).toBe(WORDS)
    expect(workers[0].isTerminated).toBe(true)
    expect(told()).toEqual([])
    store.update(undo)
    expect(store.state.setup).toEqual(before)
  })

  it('planner and diagonal rule are those that were chosen last', async () => {
    generate(large, WORDS)
    store.update((state) => {
      const ruled = withDiagonal(state.setup, 'only-when-no-obstacles')
      return change(state, { ...ruled, plannerId: 'bug1' }, '')
    })
    await workers[0].finish()
    expect(store.state.setup).toMatchObject({
      plannerId: 'bug1',
      problem: { diagonal: 'only-when-no-obstacles', grid: large.size },
    })
  })

  it('who changes the map meanwhile keeps it, and is told so', async () => {
    generate(large, WORDS)
    store.update((state) => change(state, drawnOn(state), ''))
    const drawn = store.state
    await settled()
    expect(workers[0].isTerminated).toBe(true)
    await workers[0].finish()
    expect(store.state).toMatchObject({ setup: drawn.setup, history: drawn.history })
    expect(told()).toEqual([['note', CHANGED]])
  })

  it('a stroke that goes on is kept; one that was taken back is none', async () => {
    generate(large, WORDS)
    store.update((state) => edit(state, drawnOn(state)))
    const { setup } = store.state
    await workers[0].finish()
    expect(store.state.setup).toBe(setup)
    expect(told()).toEqual([['note', CHANGED]])

    store.update(cancel)
    generate(large, WORDS)
    store.update((state) => edit(state, drawnOn(state)))
    store.update(cancel)
    await workers[1].finish()
    expect(store.state.setup.problem.grid.width).toBe(257)
  })

  it.each([small, large])('only the map that was asked for last comes: %o', async (last) => {
    generate({ ...large, seed: 1 }, WORDS)
    generate(last, WORDS)
    await workers[0].finish()
    await workers[1]?.finish()
    expect(workers[0].isTerminated).toBe(true)
    expect(store.state.setup.problem.grid.walls).toEqual(wallsOf(last))
    expect(store.state.history.past.length).toBe(1)
    expect(told()).toEqual([])
  })

  it('that lasts is shown, and can be cancelled', async () => {
    const before = store.state.setup
    vi.useFakeTimers()
    generate(large, WORDS)
    vi.advanceTimersByTime(200)
    expect(told()).toEqual([['work', 'Generating…']])
    store.update((state) => dismiss(state, state.messages[0].id))
    vi.useRealTimers()
    await settled()
    expect(workers[0].isTerminated).toBe(true)
    expect(told()).toEqual([['note', 'Cancelled.']])
    expect(store.state.setup).toBe(before)
  })

  it('that fails says why', async () => {
    const before = store.state.setup
    generate(large, WORDS)
    workers[0].say({ kind: 'refused', message: 'No room.' })
    await settled()
    generate(large, WORDS)
    workers[1].onerror?.({})
    await settled()
    expect(told()).toEqual([
      ['error', 'No map was generated. No room.'],
      ['error', `No map was generated. ${MISSING_PART}`],
    ])
    expect(store.state.setup).toBe(before)
  })
})
