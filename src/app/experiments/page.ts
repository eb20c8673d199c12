import { saveSettings } from '../../experiments/settings-check'
import { byId, setText } from '../element'
import { download } from '../files/download'
import { drawIcons } from '../icons'
import { messages } from '../panels/messages'
import { themeButton } from '../panels/theme-button'
import { createStore } from '../state/store'
import { readOnReturn } from '../storage/on-return'
import { browserShelf, loadPreferences, savePreferences } from '../storage/storage'
import { bindFiles } from './open-files'
import { resultsPanel } from './results-panel'
import { runCard } from './run-card'
import { runningFor } from './running'
import { settingsForm } from './settings-form'
import { initialState, type PageState } from './state'

/** Puts the page of the experiments together. */
export function startExperiments(): void {
  const shelf = browserShelf()
  const store = createStore(initialState(loadPreferences(shelf)))
  drawIcons(document)
  const lightness = window.matchMedia('(prefers-color-scheme: light)')
  const isDark = ({ preferences: { theme } }: PageState) =>
    theme === 'system' ? !lightness.matches : theme === 'dark'

  const files = bindFiles(store)
  const running = runningFor(store)
  const form = settingsForm(store, files.openMaps)
  const showRun = runCard({
    start() {
      form.focusFault(store.state)
      running.start()
    },
    cancel: running.cancel,
  })
  const showResults = resultsPanel(store)
  const showMessages = messages(store)
  const showTheme = themeButton((theme) => {
    store.update((state) => ({ ...state, preferences: { ...state.preferences, theme } }))
    savePreferences(shelf, store.state.preferences)
  })
  byId('open', HTMLButtonElement).addEventListener('click', files.open)
  byId('save-settings', HTMLButtonElement).addEventListener('click', () => {
    const { checked } = store.state
    if (checked.kind === 'fault') form.focusFault(store.state)
    else
      download(saveSettings(checked.settings), 'application/json', 'path-planner-experiment.json')
  })
  const live = byId('live', HTMLParagraphElement)

  const show = () => {
    const { state } = store
    document.documentElement.setAttribute('theme', isDark(state) ? 'dark' : 'light')
    form.show(state)
    showRun(state)
    showResults(state, isDark(state))
    showMessages(state)
    showTheme(state.preferences.theme)
    setText(live, state.said)
  }
  readOnReturn(store, shelf)
  inFrames(show, store.subscribe, lightness)
  show()
}

/** Shows what changed once in a frame, however often it changed. */
function inFrames(
  show: () => void,
  subscribe: (listener: () => void) => void,
  lightness: MediaQueryList,
): void {
  let isAsked = false
  const ask = () => {
    if (isAsked) return
    isAsked = true
    requestAnimationFrame(() => {
      isAsked = false
      show()
    })
  }
  subscribe(ask)
  lightness.addEventListener('change', ask)
}
