import { Tape } from '../../trace/tape'
import type { Tempo } from '../playback/speeds'
import { keepTimeline } from '../playback/timeline'
import type { Shown, State } from '../state/state'
import type { Store } from '../state/store'
import {
  planArrived,
  planCancelled,
  planFailed,
  planIsSlow,
  planProgressed,
  planStands,
  planStarted,
} from '../state/transitions'
import { planningWorker } from './planning-worker'
import { Solver } from './solver'

const SLOW_AFTER_MS = 200

export interface Planning {
  /** Asks for a plan for the setup on screen. */
  ask(): void
  cancel(): void
  /** To be called in every frame while a plan is worked on. */
  tick(): void
}

/**
 * Joins the solver to the state: every new setup is planned, and what comes of it is shown.
 * @param welcome how a new plan is played; `null` if its end is to be shown at once
 */
export function planningFor(
  store: Store<State>,
  welcome: (shown: Shown) => Tempo | null,
): Planning {
  const solver = new Solver(planningWorker, () => performance.now(), {
    started: () => store.update(planStarted),
    progressed: (done) => store.update((state) => planProgressed(state, done)),
    arrived(
      { setup, instant },
      { outcome, tape: data, last, checkpoints, timeline, milliseconds },
    ) {
      const tape = Tape.from(data)
      keepTimeline(tape, timeline)
      const shown = { setup, instant, outcome, tape, last, checkpoints, milliseconds }
      store.update((state) => planArrived(state, shown, welcome(shown)))
    },
    failed: ({ setup }, message) => store.update((state) => planFailed(state, setup, message)),
  })
  const ask = () => {
    const { setup, committed } = store.state
    solver.ask({ setup, instant: setup !== committed })
  }
  /** An edit that is taken back, as a finger's before a second one comes, costs no new plan. */
  const askIfNew = () => {
    if (store.state.shown?.setup !== store.state.setup) return ask()
    solver.cancel()
    store.update(planStands)
  }
  store.subscribe((now, before) => {
    if (now.setup !== before.setup) askIfNew()
    if (now.committed !== before.committed) solver.editEnded()
  })
  return {
    ask,
    cancel() {
      solver.cancel()
      store.update(planCancelled)
    },
    tick() {
      solver.tick()
      if (solver.elapsed > SLOW_AFTER_MS) store.update(planIsSlow)
    },
  }
}
