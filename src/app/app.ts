import { emptyGrid } from '../grid/grid'
import { Picture } from '../render/picture'
import { announcer } from './announcer'
import { aboutDialog } from './dialogs/about-planner'
import { dialog } from './dialogs/dialog'
import { generateDialog } from './dialogs/generate'
import { newMapDialog } from './dialogs/new-map'
import { scenariosDialog } from './dialogs/scenarios'
import { byId } from './element'
import { bindFiles, saveFile } from './files'
import { drawIcons } from './icons'
import { keeper } from './keeper'
import { Cards } from './layout/cards'
import { mapAttributes, mapLabel } from './map-attributes'
import { hint } from './panels/hint'
import { mapMenu } from './panels/map-menu'
import { messages } from './panels/messages'
import { plannerCard } from './panels/planner-card'
import { resultCard } from './panels/result-card'
import { toolbar } from './panels/toolbar'
import { planningWorker } from './planning-worker'
import { Playback } from './playback'
import { sceneOf } from './scene'
import { withGrid } from './setup'
import { Solver } from './solver'
import { beginWith } from './start'
import { initialState, type State } from './state'
import { browserShelf, loadPreferences, loadSetup } from './storage'
import { createStore, type Store } from './store'
import { bindInput } from './tools/bind'
import {
  change,
  hidePath,
  layOut,
  planArrived,
  planCancelled,
  planFailed,
  planIsSlow,
  planProgressed,
  planStarted,
  prefer,
  tell,
} from './transitions'

const SLOW_AFTER_MS = 200
const PLAYED_ONCE = { duration: 1000, times: 1, pause: 0 }
/** For newcomers: slow enough to see what is going on, and more than once. */
const SHOWCASE = { duration: 4500, times: 3, pause: 1500 }

/** Puts the page together: state, solver, panels and picture, and the one animation frame. */
export function startApp(): void {
  const shelf = browserShelf()
  const { setup, isFirstVisit, message } = beginWith(loadSetup(shelf))
  const store = createStore(initialState(setup, loadPreferences(shelf)))
  const map = byId('map', HTMLDivElement)
  const picture = new Picture(map)
  const stillness = window.matchMedia('(prefers-reduced-motion: reduce)')
  const lightness = window.matchMedia('(prefers-color-scheme: light)')
  drawIcons(document)

  let playback: Playback | null = null
  let isShowcase = isFirstVisit
  let frameRequested = false
  let layoutChange: 'none' | 'content' | 'user' = 'user'
  let rendered: State | null = null

  const requestFrame = () => {
    if (frameRequested) return
    frameRequested = true
    requestAnimationFrame(drawFrame)
  }

  const solver = new Solver(planningWorker, () => performance.now(), {
    started: () => store.update(planStarted),
    progressed: (done) => store.update((state) => planProgressed(state, done)),
    arrived: ({ setup: answered, instant }, { outcome, tape, last, milliseconds }) =>
      store.update((state) =>
        planArrived(state, { setup: answered, instant, outcome, tape, last, milliseconds }),
      ),
    failed: ({ setup: answered }, why) => store.update((state) => planFailed(state, answered, why)),
  })
  const ask = ({ setup: asked, committed }: State) =>
    solver.ask({ setup: asked, instant: asked !== committed })

  const coversChanged = (byUser: boolean) => {
    layoutChange = byUser ? 'user' : layoutChange === 'none' ? 'content' : layoutChange
    requestFrame()
  }
  const cards = new Cards(document, coversChanged)
  const attempt = (action: () => void) => attemptOn(store, action)
  const openDialog = (id: string) => {
    const element = dialog(id)
    return () => element.showModal()
  }
  const openHelp = openDialog('help-dialog')
  const panels = [
    plannerCard(store, aboutDialog(store)),
    resultCard({
      cancel() {
        solver.cancel()
        store.update(planCancelled)
      },
      planAgain: () => ask(store.state),
    }),
    toolbar(store, openHelp),
    messages(store),
    hint(store, () => coversChanged(true)),
    announcer(byId('live', HTMLParagraphElement)),
  ]
  mapMenu({
    new: newMapDialog(store, attempt),
    scenarios: scenariosDialog(store),
    generate: generateDialog(store, attempt),
    open: bindFiles(store),
    save: () => saveFile(store),
    'clear-obstacles': () => store.update(withoutObstacles),
    'clear-path': () => store.update(hidePath),
  })
  bindInput(map, store, openHelp)

  const keep = keeper(
    shelf,
    () => store.state,
    () => store.update((state) => tell(state, 'note', NOT_KEPT)),
  )
  store.subscribe((now, before) => {
    if (now.setup !== before.setup) {
      isShowcase = isShowcase && now.setup === setup
      playback = null
      ask(now)
    }
    // Who has changed something needs no greeting any more.
    if (now.committed !== before.committed) store.update((state) => prefer(state, { hint: false }))
    if (now.shown !== before.shown && now.shown) {
      const atOnce = now.shown.instant || now.shown.setup !== now.setup || stillness.matches
      playback = atOnce ? null : new Playback(now.shown, isShowcase ? SHOWCASE : PLAYED_ONCE)
    }
    keep(now, before)
    describeMap()
    requestFrame()
  })

  const isDark = ({ preferences }: State) =>
    preferences.theme === 'system' ? !lightness.matches : preferences.theme === 'dark'

  const describeMap = () => {
    Object.assign(map.dataset, mapAttributes(store.state, playback !== null))
  }

  const layOutPage = () => {
    const [width, height] = [window.innerWidth, window.innerHeight]
    const { screen } = store.state
    const byUser = layoutChange === 'user'
    layoutChange = 'none'
    if (screen.width !== width || screen.height !== height) cards.keepOnScreen()
    store.update((state) => layOut(state, { width, height }, cards.rects(), byUser))
  }

  function drawFrame(now: number): void {
    frameRequested = false
    solver.tick()
    if (solver.elapsed > SLOW_AFTER_MS) store.update(planIsSlow)
    if (store.state !== rendered) {
      document.documentElement.setAttribute('theme', isDark(store.state) ? 'dark' : 'light')
      for (const show of panels) show(store.state)
      map.setAttribute('aria-label', mapLabel(store.state))
    }
    if (layoutChange !== 'none') layOutPage()
    rendered = store.state
    const frame = playback?.frameAt(now) ?? null
    if (!frame) playback = null
    picture.draw(sceneOf(rendered, isDark(rendered), frame), rendered.view)
    describeMap()
    if (playback || rendered.run.kind === 'running') requestFrame()
  }

  const resize = () => {
    picture.resize(window.innerWidth, window.innerHeight, window.devicePixelRatio)
    layoutChange = 'user'
    requestFrame()
  }
  const endShowcase = () => {
    if (isShowcase) playback = null
    isShowcase = false
    requestFrame()
  }
  window.addEventListener('resize', resize)
  window.addEventListener('pointerdown', endShowcase, { once: true })
  window.addEventListener('keydown', endShowcase, { once: true })
  lightness.addEventListener('change', () => {
    rendered = null
    requestFrame()
  })

  if (message) store.update((state) => tell(state, 'note', message))
  resize()
  ask(store.state)
}

const NOT_KEPT =
  'This browser keeps nothing for the next visit: its storage is full or not allowed. Save the map to keep it.'

function withoutObstacles(state: State): State {
  const { width, height, walls } = state.setup.problem.grid
  if (!walls.includes(1)) return state
  const cleared = withGrid(state.setup, emptyGrid(width, height))
  return change(state, cleared, 'All obstacles are cleared.')
}

/** Runs what may refuse its input; why it does is shown, and all stays as it was. */
function attemptOn(store: Store<State>, action: () => void): void {
  try {
    action()
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error)
    store.update((state) => tell(state, 'error', why))
  }
}
