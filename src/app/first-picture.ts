import type { State } from './state'
import type { Store } from './store'

const PATIENCE_MS = 250

/**
 * Opens the page once its first plan is there, or when that is late: to lay the page out and to draw
 * it without the plan first takes a slow machine longer than most plans.
 */
export function oncePlanned(store: Store<State>, open: () => void): void {
  const go = () => {
    clearTimeout(late)
    unsubscribe()
    open()
  }
  const late = setTimeout(go, PATIENCE_MS)
  const unsubscribe = store.subscribe(({ run }) => {
    if (run.kind !== 'running') go()
  })
}
