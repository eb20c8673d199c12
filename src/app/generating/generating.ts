import type { Problem } from '../../grid/problem'
import { MapsBeside } from '../files/map-beside'
import { askForMap } from '../files/map-worker'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { attempt, changeMap } from '../state/transitions'
import { generatingWorker } from './generating-worker'
import { makeMap, type WantedMap } from './wanted-map'

/** Up to so many cells, a map is generated well within a frame, and needs no worker. */
const MOST_AT_ONCE = 2 ** 16

const WORDS = { doing: 'Generating…', failed: 'No map was generated' }

/**
 * Returns what generates a map and puts it on the page, with words for those who listen: a small one at
 * once, a large one when a worker has made it.
 */
export function generatingFor(
  store: Store<State>,
  makeWorker = generatingWorker,
): (wanted: WantedMap, words: string) => void {
  const beside = new MapsBeside(store)

  return (wanted, words) => {
    const shown = (state: State, { diagonal: _, ...made }: Problem) => {
      const { diagonal } = state.setup.problem
      return changeMap(state, { ...state.setup, problem: { ...made, diagonal } }, words)
    }
    if (wanted.size.width * wanted.size.height <= MOST_AT_ONCE) {
      beside.stop()
      store.update((state) => attempt(state, () => shown(state, makeMap(wanted))))
      return
    }
    void beside.make({
      words: WORDS,
      make: (signal) => askForMap(makeWorker(), wanted, signal),
      put: ({ problem }) => store.update((state) => shown(state, problem)),
    })
  }
}
