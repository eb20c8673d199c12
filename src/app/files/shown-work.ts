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
  const show = () => {
    if (id > 0) return
    store.update((state) => tell(state, 'work', words))
    id = store.state.messagesTold
  }
  // Not all work says how far it is.
  const timer = setTimeout(show, SLOW_AFTER_MS)
  const progress = (done: number) => {
    if (performance.now() - began > SLOW_AFTER_MS) show()
    store.update((state) => workProgressed(state, id, done))
  }
  const unsubscribe = store.subscribe(({ messages }) => {
    if (id > 0 && !messages.some((message) => message.id === id)) cancel.abort()
  })
  try {
    const result = await work({ progress, signal: cancel.signal })
    cancel.signal.throwIfAborted()
    return result
  } catch (error) {
    if (!cancel.signal.aborted) throw error
    store.update((state) => tell(state, 'note', 'Cancelled.'))
    return null
  } finally {
    clearTimeout(timer)
    unsubscribe()
    store.update((state) => dismiss(state, id))
  }
}
