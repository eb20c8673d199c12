import { afterEach, expect, it, vi } from 'vitest'
import { planningFor } from '../../../src/app/planning/planning'
import { withMark } from '../../../src/app/state/setup'
import { isSettled } from '../../../src/app/state/state'
import { createStore } from '../../../src/app/state/store'
import { cancel, edit, planArrived } from '../../../src/app/state/transitions'
import { FakeWorker } from '../fake-worker'
import { planned, stateFrom } from '../setups'

afterEach(() => vi.unstubAllGlobals())

/** A page with a plan on screen, and the workers that it makes. */
function pageWithPlan() {
  const workers: FakeWorker<unknown, unknown>[] = []
  vi.stubGlobal(
    'Worker',
    class extends FakeWorker<unknown, unknown> {
      constructor() {
        super()
        workers.push(this)
      }
    },
  )
  const begin = stateFrom('S...\n....\n...G')
  const store = createStore(planArrived(begin, planned(begin.setup)))
  planningFor(store, () => null)
  const questions = () => workers.flatMap((worker) => worker.questions).length
  return { store, questions, moved: withMark(begin.setup, 'goal', 10) }
}

it('an edit that is taken back before its plan is there asks for no other', () => {
  const { store, questions, moved } = pageWithPlan()
  store.update((state) => edit(state, moved))
  expect(questions()).toBe(1)
  store.update(cancel)
  expect(questions()).toBe(1)
  expect(isSettled(store.state)).toBe(true)
})

it('the next edit is planned as ever', () => {
  const { store, questions, moved } = pageWithPlan()
  store.update((state) => edit(state, moved))
  store.update(cancel)
  store.update((state) => edit(state, moved))
  expect(questions()).toBe(2)
  expect(store.state.run.kind).toBe('running')
})
