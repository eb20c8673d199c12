import { messageOf } from '../../grid/errors'
import { fetchedPart } from '../fetched-part'
import { tell } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'

/** What opens the dialogs; each is loaded when it is opened first. */
export const dialogsOf = (store: Store<State>) => ({
  new: onDemand(store, async () => (await import('./new-map')).newMapDialog(store)),
  scenarios: onDemand(store, async () => (await import('./scenarios')).scenariosDialog(store)),
  generate: onDemand(store, async () => (await import('./generate')).generateDialog(store)),
  about: onDemand(store, async () => (await import('./about-planner')).aboutDialog(store)),
  help: onDemand(store, async () => (await import('./help')).helpDialog()),
})

/**
 * Opens a part of the page that is loaded when it is first asked for. If that fails, a message says
 * so, and the next try loads it again.
 * @param load gives what opens the part
 */
function onDemand(store: Store<State>, load: () => Promise<() => void>): () => void {
  let open: (() => void) | null = null
  let isLoading = false

  const loadAndOpen = async () => {
    isLoading = true
    try {
      open = await fetchedPart(load())
    } catch (error) {
      store.update((state) => tell(state, 'error', messageOf(error)))
    }
    isLoading = false
    open?.()
  }
  return () => {
    if (open) open()
    else if (!isLoading) void loadAndOpen()
  }
}
