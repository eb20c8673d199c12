import { messageOf } from '../../grid/errors'
import type { Problem } from '../../grid/problem'
import { showWork } from '../files/shown-work'
import { tell } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { attempt, changeMap } from '../state/transitions'
import { askForMap, generatingWorker } from './generating-worker'
import { makeMap, type WantedMap } from './wanted-map'

/** Up to so many cells, a map is generated well within a frame, and needs no worker. */
const MOST_AT_ONCE = 2 ** 16

const CHANGED = 'No map was generated, because the one on screen was changed meanwhile.'

/**
 * Returns what generates a map and puts it on the page, with words for those who listen: a small one at
 * once, a large one when a worker has made it. The page can be used until then; who changes the map on
 * screen keeps it.
 */
export function generatingFor(
  store: Store<State>,
  makeWorker = generatingWorker,
): (wanted: WantedMap, words: string) => void {
  let stopLatest = () => {}

  const generateBeside = async (wanted: WantedMap, put: (made: Problem) => void) => {
    const { problem } = store.state.setup
    const stop = new AbortController()
    const stopIfChanged = (now: Problem) => {
      if (!isSameMap(now, problem)) stop.abort()
    }
    const unsubscribe = store.subscribe(({ committed }) => stopIfChanged(committed.problem))
    let isLatest = true
    stopLatest = () => {
      isLatest = false
      stop.abort()
    }
    try {
      const made = await showWork(store, 'Generating…', ({ signal }) => {
        signal.addEventListener('abort', () => stop.abort(signal.reason))
        return askForMap(makeWorker(), wanted, stop.signal)
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
          ? tell(state, 'note', CHANGED)
          : tell(state, 'error', `No map was generated. ${messageOf(error)}`),
      )
    } finally {
      unsubscribe()
    }
  }

  return (wanted, words) => {
    stopLatest()
    const shown = (state: State, { diagonal: _, ...made }: Problem) => {
      const { diagonal } = state.setup.problem
      return changeMap(state, { ...state.setup, problem: { ...made, diagonal } }, words)
    }
    if (wanted.size.width * wanted.size.height <= MOST_AT_ONCE) {
      store.update((state) => attempt(state, () => shown(state, makeMap(wanted))))
    } else {
      void generateBeside(wanted, (made) => store.update((state) => shown(state, made)))
    }
  }
}

const isSameMap = (a: Problem, b: Problem) =>
  a.grid === b.grid && a.start === b.start && a.goal === b.goal
