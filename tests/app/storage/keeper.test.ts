import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { Setup } from '../../../src/app/state/setup'
import type { State } from '../../../src/app/state/state'
import { createStore, type Store } from '../../../src/app/state/store'
import { change, prefer } from '../../../src/app/state/transitions'
import { keep } from '../../../src/app/storage/keeper'
import type { Shelf } from '../../../src/app/storage/storage'
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

/** The setup with this seed is that of a link. */
const LINKED_SEED = 99
const isLinked = ({ seed }: Setup) => seed === LINKED_SEED

/** Which seeds are kept on a shelf, in their order. */
function keepSeeds(): number[] {
  const seeds: number[] = []
  const shelf: Shelf = {
    getItem: () => null,
    setItem(key, text) {
      if (key === 'path-planner.setup') seeds.push(JSON.parse(text).seed)
    },
  }
  keep(store, shelf, isLinked)
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

it('keeps what was drawn, not what a link brought, until that is changed', () => {
  const seeds = keepSeeds()
  edit(2, 0)
  edit(LINKED_SEED, 10_000)
  expect(seeds).toEqual([2])
  edit(3, 10_000)
  expect(seeds).toEqual([2, 3])
})

it('says once if nothing can be kept', () => {
  keep(store, null, isLinked)
  store.update((state) => prefer(state, { theme: 'light' }))
  expect(store.state.messagesTold).toBe(0)
  for (const seed of [2, 3, 4]) edit(seed, 10_000)
  expect(store.state.messages.map(({ kind, text }) => [kind, text])).toEqual([
    ['note', expect.stringMatching(/^This browser keeps nothing/)],
  ])
  expect(store.state.messagesTold).toBe(1)
})
