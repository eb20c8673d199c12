import { expect, it, vi } from 'vitest'
import { createStore } from '../../../src/app/state/store'

it('tells its listeners of each change, and of nothing else, until they stop', () => {
  const store = createStore(1)
  const [first, second] = [vi.fn(), vi.fn()]
  const stop = store.subscribe(first)
  store.subscribe(second)
  store.update((state) => state + 1)
  store.update((state) => state)
  expect(store.state).toBe(2)
  stop()
  store.update(() => 7)
  expect(first.mock.calls).toEqual([[2, 1]])
  expect(second.mock.calls).toEqual([
    [2, 1],
    [7, 2],
  ])
})
