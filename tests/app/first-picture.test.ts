import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { oncePlanned } from '../../src/app/first-picture'
import { createStore } from '../../src/app/state/store'
import {
  planArrived,
  planFailed,
  planProgressed,
  planStarted,
} from '../../src/app/state/transitions'
import { planned, stateFrom } from './setups'

beforeEach(() => {
  vi.useFakeTimers()
})

afterEach(() => {
  vi.useRealTimers()
})

function waiting() {
  const store = createStore(planStarted(stateFrom('S...\n...G')))
  const open = vi.fn()
  oncePlanned(store, open)
  store.update((state) => planProgressed(state, 0.5))
  expect(open).not.toHaveBeenCalled()
  return { store, open }
}

it('opens the page with its first plan, and once', () => {
  const { store, open } = waiting()
  store.update((state) => planArrived(state, planned(state.setup)))
  expect(open).toHaveBeenCalledTimes(1)
  store.update((state) => planArrived(state, planned(state.setup)))
  vi.runAllTimers()
  expect(open).toHaveBeenCalledTimes(1)
})

it('opens the page if there is no plan', () => {
  const { store, open } = waiting()
  store.update((state) => planFailed(state, state.setup, 'the worker broke'))
  expect(open).toHaveBeenCalledTimes(1)
})

it('opens the page if the plan is late', () => {
  const { store, open } = waiting()
  vi.advanceTimersByTime(1000)
  expect(open).toHaveBeenCalledTimes(1)
  store.update((state) => planArrived(state, planned(state.setup)))
  expect(open).toHaveBeenCalledTimes(1)
})
