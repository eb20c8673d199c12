import { messageOf } from '../../grid/errors'
import type { OpenedMap } from '../../grid/formats/opened-map'
import type { Problem } from '../../grid/problem'
import { tell } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { showWork } from './shown-work'

/** A map that is made while the page goes on. */
interface WantedMap {
  /** What is being done, and what is not if there will be no map. */
  readonly words: { readonly doing: string; readonly failed: string }
  make(signal: AbortSignal): Promise<OpenedMap>
  put(made: OpenedMap): void
}

/**
 * Makes maps beside the page, which can be used until they come. Only the one that was asked for last
 * comes; who changes the map on screen meanwhile keeps that.
 */
export class MapsBeside {
  readonly #store: Store<State>
  #stopLatest = () => {}

  constructor(store: Store<State>) {
    this.#store = store
  }

  /** The map that is being made is not wanted any more. */
  stop(): void {
    this.#stopLatest()
  }

  async make({ words, make, put }: WantedMap): Promise<void> {
    this.stop()
    const store = this.#store
    const { problem } = store.state.setup
    const stop = new AbortController()
    const stopIfChanged = (now: Problem) => {
      if (!isSameMap(now, problem)) stop.abort()
    }
    const unsubscribe = store.subscribe(({ committed }) => stopIfChanged(committed.problem))
    let isLatest = true
    this.#stopLatest = () => {
      isLatest = false
      stop.abort()
    }
    try {
      const made = await showWork(store, words.doing, ({ signal }) => {
        signal.addEventListener('abort', () => stop.abort(signal.reason))
        return make(stop.signal)
      })
      if (!made) return
      // A stroke that still goes on counts as well.
      stopIfChanged(store.state.setup.problem)
      stop.signal.throwIfAborted()
      put(made)
    } catch (error) {
      if (!isLatest) return
      store.update((state) =>
        stop.signal.aborted
          ? tell(state, 'note', `${words.failed}, because the map on screen was changed meanwhile.`)
          : tell(state, 'error', `${words.failed}. ${messageOf(error)}`),
      )
    } finally {
      unsubscribe()
    }
  }
}

const isSameMap = (a: Problem, b: Problem) =>
  a.grid === b.grid && a.start === b.start && a.goal === b.goal
