import { messageOf } from '../../grid/errors'
import { tell, type WithMessages } from '../state/messages'
import type { Store } from '../state/store'
import { download } from './download'
import { type ShownWork, showWork } from './shown-work'

/** A file as it is handed to the browser. */
export interface Saved {
  readonly name: string
  readonly content: string | Blob
  /** What it leaves out, in words, if it does. */
  readonly missing?: string
}

/** After less, Safari may still be looking at a download, and drop it for the next one. */
const BETWEEN_DOWNLOADS_MS = 500

const pause = (milliseconds: number) =>
  new Promise<void>((resolve) => {
    setTimeout(resolve, milliseconds)
  })

/**
 * Saves files that may take long to be made. If that fails, a message says so.
 * @returns those that were saved
 */
export async function saveFiles<State extends WithMessages>(
  store: Store<State>,
  make: (work: ShownWork) => Promise<readonly Saved[]>,
): Promise<readonly Saved[]> {
  try {
    const files = await showWork(store, 'Saving…', make)
    for (const [i, { name, content, missing }] of (files ?? []).entries()) {
      if (i > 0) await pause(BETWEEN_DOWNLOADS_MS)
      download(content, typeOf(name), name)
      if (missing) store.update((state) => tell(state, 'note', missing))
    }
    return files ?? []
  } catch (error) {
    store.update((state) => tell(state, 'error', `Nothing was saved. ${messageOf(error)}`))
    return []
  }
}

const TYPES: Readonly<Record<string, string>> = {
  csv: 'text/csv',
  json: 'application/json',
  map: 'text/plain',
  png: 'image/png',
  svg: 'image/svg+xml',
}

const typeOf = (name: string): string => TYPES[name.slice(name.lastIndexOf('.') + 1)] ?? ''
