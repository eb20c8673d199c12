import { dismiss, tell, type WithMessages, workProgressed } from '../state/messages'
import type { Store } from '../state/store'

/** What work needs that can be seen and cancelled. */
export interface ShownWork {
  progress(done: number): void
  readonly signal: AbortSignal
}

const SLOW_AFTER_MS = 200

/**
 * Shows a message with the progress of work that lasts. Who closes it cancels the work, and is told so.
 * @returns `null` if it was cancelled
 */
export async function showWork<State extends WithMessages, Result>(
  store: Store<State>,
  words: string,
  work: (shown: ShownWork) => Promise<Result>,
): Promise<Result | null> {
  const began = performance.now()
  const cancel = new AbortController()
  let id = 0
  const progress = (done: number) => {
    if (id === 0 && performance.now() - began > SLOW_AFTER_MS) {
      store.update((state) => tell(state, 'work', words))
      id = store.state.messagesTold
    }
    store.update((state) => workProgressed(state, id, done))
  }
  const unsubscribe = store.subscribe(({ messages }) => {
    if (id > 0 && !messages.some((message) => message.id === id)) cancel.abort()
  })
  try {
    return await work({ progress, signal: cancel.signal })
  } catch (error) {
    if (!cancel.signal.aborted) throw error
    store.update((state) => tell(state, 'note', 'Cancelled.'))
    return null
  } finally {
    unsubscribe()
    store.update((state) => dismiss(state, id))
  }
}
