import type { State } from '../state/state'
import type { Store } from '../state/store'
import { isSameSubject } from './compared'
import { Comparer } from './comparer'
import { comparingWorker } from './comparing-worker'
import { comparisonFailed, comparisonReady, planCompared, planTimed } from './transitions'

/** Joins the comparer to the state: while planners are compared, so is every new setup. */
export function comparingFor(store: Store<State>): void {
  const comparer = new Comparer(comparingWorker, {
    planned: (subject, plan) => store.update((state) => planCompared(state, subject, plan)),
    timed: (subject, plannerId, milliseconds) =>
      store.update((state) => planTimed(state, subject, plannerId, milliseconds)),
    finished: (subject) => store.update((state) => comparisonReady(state, subject)),
    failed: (subject, message) =>
      store.update((state) => comparisonFailed(state, subject, message)),
  })
  store.subscribe((now, before) => {
    const { isOn } = now.comparison
    if (!isOn && before.comparison.isOn) comparer.stop()
    const isNew = !before.comparison.isOn || !isSameSubject(now.setup, before.setup)
    if (isOn && isNew) comparer.ask(now.setup)
  })
}
