import { comparingFor } from './compare/comparing'
import { dialogsOf } from './dialogs/on-demand'
import { byId } from './element'
import { bindFiles } from './files/files'
import { savers } from './files/save'
import { oncePlanned } from './first-picture'
import { drawIcons } from './icons'
import { compareCard } from './panels/compare-card'
import { crowdedNote } from './panels/crowded-note'
import { hint } from './panels/hint'
import { mapMenu } from './panels/map-menu'
import { messages } from './panels/messages'
import { plannerCard } from './panels/planner-card'
import { playbackBar } from './panels/playback-bar'
import { resultCard } from './panels/result-card'
import { stepsCard } from './panels/steps-card'
import { toolbar } from './panels/toolbar'
import { type Planning, planningFor } from './planning/planning'
import { SHOWCASE, type Tempo, WELCOME } from './playback/speeds'
import { type Panel, Stage } from './stage'
import { beginWith } from './start'
import { tell } from './state/messages'
import type { Setup } from './state/setup'
import { initialState, type Shown, type State } from './state/state'
import { createStore, type Store } from './state/store'
import { clearObstacles, hidePath } from './state/transitions'
import { keep } from './storage/keeper'
import { readOnReturn } from './storage/on-return'
import { bindLink } from './storage/open-link'
import { browserShelf, loadPreferences, loadSetup } from './storage/storage'
import { bindInput } from './tools/bind'
import { announcer } from './words/announcer'

/** Puts the page together: the state, what changes it, and what shows it. */
export function startApp(): void {
  const shelf = browserShelf()
  const { setup, isFirstVisit, message } = beginWith(loadSetup(shelf))
  const store = createStore(initialState(setup, loadPreferences(shelf)))
  const isLinked = bindLink(store)
  const planning = planningFor(store, welcomes(store, isFirstVisit, isLinked))
  // The worker plans while the page is put together.
  planning.ask()

  const map = byId('map', HTMLDivElement)
  drawIcons(document)
  const stage = new Stage(store, map, planning.tick)
  comparingFor(store)
  keep(store, shelf, isLinked)
  readOnReturn(store, shelf)
  const dialogs = dialogsOf(store)
  const shown = panels(store, planning, stage, dialogs)
  oncePlanned(store, () => stage.open(shown))
  bindInput(map, store, dialogs.help)

  if (message) store.update((state) => tell(state, 'note', message))
}

function panels(
  store: Store<State>,
  planning: Planning,
  stage: Stage,
  { about, help, ...others }: ReturnType<typeof dialogsOf>,
): readonly Panel[] {
  mapMenu({
    ...others,
    open: bindFiles(store),
    ...savers(store, () => stage.scene()),
    'clear-obstacles': () => store.update(clearObstacles),
    'clear-path': () => store.update(hidePath),
  })
  return [
    plannerCard(store, about),
    resultCard(store, planning),
    stepsCard(store),
    compareCard(store, () => stage.coversChanged(true)),
    playbackBar(store),
    crowdedNote(),
    toolbar(store, help),
    messages(store),
    hint(store, () => stage.coversChanged(true)),
    announcer(byId('live', HTMLParagraphElement)),
  ]
}

/**
 * How a plan that arrives is played. `null` shows its end at once: while the pointer is down, if the
 * user prefers less motion, and for the setup of a link, because that shows how it ended.
 */
function welcomes(
  store: Store<State>,
  isFirstVisit: boolean,
  isLinked: (setup: Setup) => boolean,
): (shown: Shown) => Tempo | null {
  const stillness = window.matchMedia('(prefers-reduced-motion: reduce)')
  let isShowcase = isFirstVisit && !isLinked(store.state.setup)
  const endShowcase = () => {
    isShowcase = false
  }
  window.addEventListener('pointerdown', endShowcase, { once: true })
  window.addEventListener('keydown', endShowcase, { once: true })

  return (shown) => {
    const isCurrent = shown.setup === store.state.setup
    const atOnce = shown.instant || !isCurrent || stillness.matches || isLinked(shown.setup)
    if (atOnce) return null
    return isShowcase ? SHOWCASE : WELCOME
  }
}
