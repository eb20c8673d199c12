import type { State } from './state/state'
import type { Store } from './state/store'

const PATIENCE_MS = 250

/**
 * Opens the page together with its first plan, or without it if that is late: on a slow machine most
 * plans take less time than to lay out and draw the page twice.
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
