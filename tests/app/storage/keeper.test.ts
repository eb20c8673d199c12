import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { State } from '../../../src/app/state/state'
import { createStore, type Store } from '../../../src/app/state/store'
import { change, prefer } from '../../../src/app/state/transitions'
import { keep } from '../../../src/app/storage/keeper'
import { stateFrom } from '../setups'

let page: EventTarget
let store: Store<State>

beforeEach(() => {
  vi.useFakeTimers()
  page = new EventTarget()
  vi.stubGlobal('window', page)
  store = createStore(stateFrom('S..\n..G'))
})

afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** Commits a change of the seed, and lets so many milliseconds pass. */
function edit(seed: number, milliseconds: number): void {
  store.update((state) => change(state, { ...state.setup, seed }, 'Changed.'))
  vi.advanceTimersByTime(milliseconds)
}

/** Which seeds are kept on a shelf, in their order. */
function keepSeeds(): number[] {
  const seeds: number[] = []
  keep(store, {
    getItem: () => null,
    setItem(key, text) {
      if (key === 'path-planner.setup') seeds.push(JSON.parse(text).seed)
    },
  })
  return seeds
}

it('keeps what is drawn once edits are over', () => {
  const seeds = keepSeeds()
  edit(2, 100)
  edit(3, 100)
  expect(seeds).toEqual([])
  vi.runAllTimers()
  expect(seeds).toEqual([3])
})

it('keeps what is drawn when the page is left, and nothing twice', () => {
  const seeds = keepSeeds()
  edit(2, 0)
  page.dispatchEvent(new Event('pagehide'))
  expect(seeds).toEqual([2])
  vi.runAllTimers()
  page.dispatchEvent(new Event('pagehide'))
  expect(seeds).toEqual([2])
})

it('says once if nothing can be kept', () => {
  keep(store, null)
  store.update((state) => prefer(state, { theme: 'light' }))
  expect(store.state.messagesTold).toBe(0)
  for (const seed of [2, 3, 4]) edit(seed, 10_000)
  expect(store.state.messages.map(({ kind, text }) => [kind, text])).toEqual([
    ['note', expect.stringMatching(/^This browser keeps nothing/)],
  ])
  expect(store.state.messagesTold).toBe(1)
})
