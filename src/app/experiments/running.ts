import { countWork, type ExperimentSettings } from '../../experiments/settings'
import { WHOLE } from '../../experiments/shards'
import { timeLeft } from '../../experiments/time-left'
import { tell } from '../state/messages'
import type { Store } from '../state/store'
import { browserPool } from './browser-pool'
import type { PageState } from './state'
import { runEnded, runProgressed, runStarted } from './transitions'
import type { WorkerPool } from './worker-pool'

export interface Running {
  /** Runs what the form holds, if it can be run. */
  start(): void
  /** What is done is kept and shown. */
  cancel(): void
}

/** Has the browser ask before the page is left. */
const askFirst = (event: BeforeUnloadEvent) => event.preventDefault()

/** Joins the pool of workers to the state. */
export function runningFor(store: Store<PageState>): Running {
  let running: { readonly settings: ExperimentSettings; readonly pool: WorkerPool } | null = null

  const end = () => {
    if (!running) return
    const { settings, pool } = running
    running = null
    pool.stop()
    window.removeEventListener('beforeunload', askFirst)
    store.update((state) => runEnded(state, { settings, shard: WHOLE, rows: pool.rows }))
  }
  const run = (settings: ExperimentSettings) => {
    const total = countWork(settings).maps
    const began = performance.now()
    store.update((state) => runStarted(state, total))
    const pool = browserPool(settings, {
      progressed: (done) => {
        const left = timeLeft(done, total, performance.now() - began)
        store.update((state) => runProgressed(state, done, left))
      },
      finished: end,
      failed: (message) => {
        end()
        store.update((state) => tell(state, 'error', `The run was broken off. ${message}.`))
      },
    })
    running = { settings, pool }
    window.addEventListener('beforeunload', askFirst)
  }
  return {
    start() {
      const { checked } = store.state
      if (checked.kind === 'settings' && !running) run(checked.settings)
    },
    cancel: end,
  }
}
