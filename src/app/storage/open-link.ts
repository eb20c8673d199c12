import { messageOf } from '../../grid/errors'
import { tell, tellOfMap } from '../state/messages'
import type { Setup } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { changeMap } from '../state/transitions'
import { setupInLink } from './link'

/** Opens the setup that an address names; undo leads back to what was drawn before. */
export function openLink(state: State, hash: string): State {
  try {
    const setup = setupInLink(hash)
    if (!setup) return state
    const params = { ...state.setup.params, ...setup.params }
    const opened = changeMap(state, { ...setup, params }, 'The map of the link is open.')
    return tellOfMap(
      opened,
      'note',
      'This is the map of a link. Undo brings back what was here before.',
    )
  } catch (error) {
    return tell(state, 'error', `The link was not opened. ${messageOf(error)}`)
  }
}

/**
 * Opens the link in the address, now and whenever it changes. The link stays in the address until the
 * first edit: a reload opens it again, but never instead of what was drawn since.
 * @returns a function that says whether a setup is that of the link, unchanged
 */
export function bindLink(store: Store<State>): (setup: Setup) => boolean {
  let linked: Setup | null = null
  const open = () => {
    const opened = openLink(store.state, window.location.hash)
    // Before the state changes: whoever hears of that asks whether the setup is a link's.
    linked = opened.setup === store.state.setup ? null : opened.setup
    store.update(() => opened)
    if (!linked) forget()
  }
  const forget = () => {
    linked = null
    if (window.location.hash === '') return
    window.history.replaceState(null, '', window.location.pathname + window.location.search)
  }
  open()
  window.addEventListener('hashchange', open)
  store.subscribe(({ committed }) => {
    if (linked && committed !== linked) forget()
  })
  return (setup) => setup === linked
}
