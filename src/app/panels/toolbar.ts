import { byId } from '../element'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { prefer, redo, say, undo } from '../state/transitions'
import { wholeMapShown, ZOOM_STEP, zoomed } from '../tools/keys'
import { themeButton } from './theme-button'

/** Binds the toolbar's buttons; returns what shows a state in them. */
export function toolbar(store: Store<State>, openHelp: () => void): (state: State) => void {
  const button = (id: string, pressed: (state: State) => State): HTMLButtonElement => {
    const element = byId(id, HTMLButtonElement)
    element.addEventListener('click', () => store.update(pressed))
    return element
  }
  const undoButton = button('undo', undo)
  const redoButton = button('redo', redo)
  button('zoom-in', (state) => zoomed(state, ZOOM_STEP))
  button('zoom-out', (state) => zoomed(state, 1 / ZOOM_STEP))
  button('fit', wholeMapShown)
  const showTheme = themeButton((theme) =>
    store.update((state) => say(prefer(state, { theme }), `Theme: ${theme}.`)),
  )
  byId('help', HTMLButtonElement).addEventListener('click', openHelp)

  return ({ history, setup, committed, clearPath, preferences }) => {
    // `aria-disabled` keeps the focus where it is when the last step was undone.
    const canUndo = history.past.length > 0 || setup !== committed || clearPath === 'done'
    setDisabled(undoButton, !canUndo)
    setDisabled(redoButton, history.future.length === 0 && clearPath !== 'undone')
    showTheme(preferences.theme)
  }
}

function setDisabled(button: HTMLButtonElement, disabled: boolean): void {
  button.setAttribute('aria-disabled', String(disabled))
}
