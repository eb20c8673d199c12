import { saveSettings } from '../../experiments/settings-check'
import { byId, setText } from '../element'
import { download } from '../files/download'
import { drawIcons } from '../icons'
import { PageTheme } from '../page-theme'
import { messages } from '../panels/messages'
import { themeButton } from '../panels/theme-button'
import { createStore } from '../state/store'
import { browserShelf, loadPreferences, savePreferences } from '../storage/storage'
import { bindFiles } from './open-files'
import { resultsPanel } from './results-panel'
import { runCard } from './run-card'
import { runningFor } from './running'
import { settingsForm } from './settings-form'
import { initialState } from './state'

/** Puts the page of the experiments together. */
export function startExperiments(): void {
  const shelf = browserShelf()
  const store = createStore(initialState(loadPreferences(shelf)))
  const showInNextFrame = onceInAFrame(() => show())
  const theme = new PageTheme(showInNextFrame)
  drawIcons(document)

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
  const showChoice = themeButton((choice) => {
    store.update((state) => ({
      ...state,
      preferences: { ...state.preferences, theme: choice },
    }))
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
    const choice = state.preferences.theme
    theme.show(choice)
    form.show(state)
    showRun(state)
    showResults(state, theme.for(choice))
    showMessages(state)
    showChoice(choice)
    setText(live, state.said)
  }
  store.subscribe(showInNextFrame)
  show()
}

/** What has `show` called in the next frame, and once, however often it is asked for. */
function onceInAFrame(show: () => void): () => void {
  let isAsked = false
  return () => {
    if (isAsked) return
    isAsked = true
    requestAnimationFrame(() => {
      isAsked = false
      show()
    })
  }
}
