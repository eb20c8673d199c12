import { countWork, type ExperimentSettings } from '../../experiments/settings'
import { WHOLE } from '../../experiments/shards'
import { timeLeft } from '../../experiments/time-left'
import type { Store } from '../store'
import { tell } from '../telling'
import { browserCrew } from './browser-crew'
import type { Crew } from './crew'
import type { PageState } from './state'
import { runEnded, runProgressed, runStarted } from './transitions'

export interface Running {
  /** Runs what the form holds, if it can be run. */
  start(): void
  /** What is done is kept and shown. */
  cancel(): void
}

/** Joins the crew of workers to the state. */
export function runningFor(store: Store<PageState>): Running {
  let crew: Crew | null = null

  const end = (settings: ExperimentSettings) => {
    const rows = crew?.rows ?? []
    crew?.stop()
    crew = null
    store.update((state) => runEnded(state, { settings, shard: WHOLE, rows }))
  }
  const run = (settings: ExperimentSettings) => {
    const total = countWork(settings).maps
    const began = performance.now()
    store.update((state) => runStarted(state, total))
    crew = browserCrew(settings, {
      progressed: (done) => {
        const left = timeLeft(done, total, performance.now() - began)
        store.update((state) => runProgressed(state, done, left))
      },
      finished: () => end(settings),
      failed: (message) => {
        end(settings)
        store.update((state) => tell(state, 'error', `The run was broken off. ${message}.`))
      },
    })
    cancel = () => end(settings)
  }
  let cancel = () => {}
  return {
    start() {
      const { checked } = store.state
      if (checked.kind === 'settings' && !crew) run(checked.settings)
    },
    cancel: () => cancel(),
  }
}
