import type { Preferences } from '../state/preferences'
import type { Store } from '../state/store'
import { loadPreferences, type Shelf } from './storage'

/**
 * Reads the preferences anew when the browser's Back leads to a page that was kept as it was: they may
 * have been changed on the other page since.
 */
export function readOnReturn<State extends { readonly preferences: Preferences }>(
  store: Store<State>,
  shelf: Shelf | null,
): void {
  window.addEventListener('pageshow', ({ persisted }) => {
    if (!persisted) return
    store.update((state) => ({ ...state, preferences: loadPreferences(shelf, state.preferences) }))
  })
}
