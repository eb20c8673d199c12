import { announcer } from './announcer'
import { aboutDialog } from './dialogs/about-planner'
import { dialog } from './dialogs/dialog'
import { generateDialog } from './dialogs/generate'
import { newMapDialog } from './dialogs/new-map'
import { scenariosDialog } from './dialogs/scenarios'
import { byId } from './element'
import { bindFiles, saveFile } from './files'
import { drawIcons } from './icons'
import { keep } from './keeper'
import { bindLink } from './open-link'
import { hint } from './panels/hint'
import { mapMenu } from './panels/map-menu'
import { messages } from './panels/messages'
import { plannerCard } from './panels/planner-card'
import { resultCard } from './panels/result-card'
import { toolbar } from './panels/toolbar'
import { type Planning, planningFor } from './planning'
import type { Setup } from './setup'
import { Stage } from './stage'
import { beginWith } from './start'
import { initialState, type State } from './state'
import { browserShelf, loadPreferences, loadSetup } from './storage'
import { createStore, type Store } from './store'
import { bindInput } from './tools/bind'
import { clearObstacles, hidePath, tell } from './transitions'

const PLAYED_ONCE = { duration: 1000, times: 1, pause: 0 }
/** For newcomers: slow enough to see what is going on, and more than once. */
const SHOWCASE = { duration: 4500, times: 3, pause: 1500 }

/** Puts the page together: the state, what changes it, and what shows it. */
export function startApp(): void {
  const shelf = browserShelf()
  const { setup, isFirstVisit, message } = beginWith(loadSetup(shelf))
  const store = createStore(initialState(setup, loadPreferences(shelf)))
  const map = byId('map', HTMLDivElement)
  drawIcons(document)

  const planning = planningFor(store)
  const stage = new Stage(store, map, planning.tick)
  const isLinked = bindLink(store)
  playPlans(store, stage, isFirstVisit, isLinked)
  // After the link, whose map takes the place of what was drawn only once it is changed.
  keep(store, shelf)
  stage.open(panels(store, planning, stage))
  bindInput(map, store, openHelp)

  if (message) store.update((state) => tell(state, 'note', message))
  planning.ask()
}

const openHelp = () => byId('help-dialog', HTMLDialogElement).showModal()

function panels(
  store: Store<State>,
  planning: Planning,
  stage: Stage,
): readonly ((state: State) => void)[] {
  dialog('help-dialog')
  mapMenu({
    new: newMapDialog(store),
    scenarios: scenariosDialog(store),
    generate: generateDialog(store),
    open: bindFiles(store),
    save: () => saveFile(store),
    'clear-obstacles': () => store.update(clearObstacles),
    'clear-path': () => store.update(hidePath),
  })
  return [
    plannerCard(store, aboutDialog(store)),
    resultCard(planning),
    toolbar(store, openHelp),
    messages(store),
    hint(store, () => stage.coversChanged(true)),
    announcer(byId('live', HTMLParagraphElement)),
  ]
}

/**
 * A plan that arrives is played; at once while the pointer is down, and if motion is unwelcome. Who
 * follows a link comes to see how it ended.
 */
function playPlans(
  store: Store<State>,
  stage: Stage,
  isFirstVisit: boolean,
  isLinked: (setup: Setup) => boolean,
): void {
  const stillness = window.matchMedia('(prefers-reduced-motion: reduce)')
  let isShowcase = isFirstVisit && !isLinked(store.state.setup)
  const endShowcase = () => {
    if (isShowcase) stage.stop()
    isShowcase = false
  }
  window.addEventListener('pointerdown', endShowcase, { once: true })
  window.addEventListener('keydown', endShowcase, { once: true })

  store.subscribe(({ setup, shown }, before) => {
    if (setup !== before.setup) stage.stop()
    if (!shown || shown === before.shown) return
    const atOnce = shown.instant || shown.setup !== setup || stillness.matches || isLinked(setup)
    if (atOnce) stage.stop()
    else stage.play(shown, isShowcase ? SHOWCASE : PLAYED_ONCE)
  })
}
