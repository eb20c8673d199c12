import { placeAfter } from '../../trace/landmarks'
import { byId, create, setText } from '../element'
import { type IconName, setIcon } from '../icons'
import { isAtEnd, type Moment } from '../playback/moment'
import { isFast, SPEEDS, speedInWords } from '../playback/speeds'
import { type Timeline, timelineOf } from '../playback/timeline'
import {
  chooseSpeed,
  stepBack,
  stepForward,
  stepNumber,
  toFirst,
  togglePlay,
  toLandmarkBefore,
  toLast,
  toNextLandmark,
  toStep,
} from '../playback/transport'
import { SIGHTS } from '../state/preferences'
import { plannerOf } from '../state/setup'
import { cellAskedAbout, type State, visiblePlan } from '../state/state'
import type { Store } from '../state/store'
import { prefer, say } from '../state/transitions'
import { cellFactsInWords, cellInWords } from '../words/cell-line'
import { numberInWords } from '../words/numbers'
import { stepInWords } from '../words/steps-in-words'
import { leftOut } from '../words/thinning'

const SIGHT_NAMES = { both: 'Both', world: 'World', known: 'What the rover knows' } as const

/** Binds the bar with which a plan is played and stepped; returns what shows a moment in it. */
export function playbackBar(store: Store<State>): (state: State, moment: Moment | null) => void {
  const buttons = Object.entries({
    'to-first': toFirst,
    'landmark-before': toLandmarkBefore,
    'step-back': stepBack,
    play: togglePlay,
    'step-forward': stepForward,
    'next-landmark': toNextLandmark,
    'to-last': toLast,
  }).map(([id, pressed]) => {
    const button = byId(id, HTMLButtonElement)
    button.addEventListener('click', () => store.update(pressed))
    return button
  })
  const play = byId('play', HTMLButtonElement)
  const playSign = play.querySelector('svg')
  const scrubber = byId('scrubber', HTMLInputElement)
  const ticks = byId('ticks', HTMLDivElement)
  const count = byId('step-count', HTMLParagraphElement)
  const speed = byId('speed', HTMLSelectElement)
  const sight = byId('sight', HTMLSelectElement)
  const sightField = byId('sight-field', HTMLDivElement)
  const cell = byId('cell-facts', HTMLParagraphElement)

  for (const choice of SPEEDS) {
    speed.append(create('option', { value: choice }, speedInWords(choice)))
  }
  for (const choice of SIGHTS) {
    sight.append(create('option', { value: choice }, SIGHT_NAMES[choice]))
  }
  // Its own keys go on from where the plan is, even if that is not drawn yet.
  scrubber.addEventListener('keydown', () => {
    const shown = visiblePlan(store.state)
    if (shown) scrubber.value = String(stepNumber(store.state, shown).step)
  })
  scrubber.addEventListener('input', () => {
    store.update((state) => toStep(state, scrubber.valueAsNumber))
  })
  speed.addEventListener('change', () => {
    const chosen = SPEEDS.find((choice) => String(choice) === speed.value)
    if (chosen) store.update((state) => chooseSpeed(state, chosen))
  })
  sight.addEventListener('change', () => {
    const chosen = SIGHTS.find((choice) => choice === sight.value)
    if (!chosen) return
    const text = `Rover's view: ${SIGHT_NAMES[chosen]}.`
    store.update((state) => say(prefer(state, { sight: chosen }), text))
  })

  const showPlaying = (isPlaying: boolean): void => {
    const name: IconName = isPlaying ? 'pause' : 'play'
    if (playSign) setIcon(playSign, name)
    play.setAttribute('aria-label', isPlaying ? 'Pause' : 'Play')
    play.title = `${isPlaying ? 'Pause' : 'Play'} (K)`
  }
  let ticked: Timeline | null = null
  const showSteps = (state: State, moment: Moment): void => {
    const { step, steps } = stepNumber(state, moment.shown)
    scrubber.max = String(steps)
    scrubber.value = String(step)
    const why = isFast(state.playing) ? '' : `: ${stepInWords(moment)}`
    scrubber.setAttribute('aria-valuetext', `step ${step} of ${steps}${why}`)
    const { briefly, words } = leftOut(moment.shown.tape.thinning)
    setText(count, `Step ${numberInWords(step)} of ${numberInWords(steps)}${briefly}`)
    count.title = words
    const timeline = timelineOf(moment.shown.tape)
    if (timeline !== ticked) showTicks(ticks, timeline)
    ticked = timeline
  }

  // It is asked for far more often than it changes, and a long tape takes a while to be read.
  let toldOf: readonly unknown[] = []
  const showCell = (state: State, moment: Moment | null): void => {
    const { problem } = state.setup
    const { start, goal, grid } = problem
    const asked = cellAskedAbout(state)
    const wall = grid.walls[asked]
    const now = [asked, start, goal, grid.width, wall, moment?.shown, moment?.frame.time]
    if (now.every((part, i) => part === toldOf[i])) return
    toldOf = now
    setText(cell, cellLine(state, moment))
  }

  return (state, moment) => {
    const { setup, committed, playing, preferences } = state
    for (const button of buttons) button.setAttribute('aria-disabled', String(!moment))
    scrubber.disabled = !moment
    showPlaying(playing !== null)
    // While a stroke goes on, plans come too fast to be counted, and only their ends are seen.
    const isCounted = setup === committed || scrubber.value !== scrubber.max
    if (moment && (isCounted || !isAtEnd(moment))) showSteps(state, moment)
    if (!moment) {
      setText(count, 'No steps')
      if (ticked) ticks.replaceChildren()
      ticked = null
    }
    speed.value = String(preferences.speed)
    sight.value = preferences.sight
    sightField.hidden = plannerOf(setup).family !== 'online'
    showCell(state, moment)
  }
}

function cellLine(state: State, moment: Moment | null): string {
  const cell = cellAskedAbout(state)
  const { problem } = state.setup
  if (cell < 0) return 'Point at a cell to see what the planner knows of it.'
  const facts = moment && cellFactsInWords(moment, problem, cell)
  return `${cellInWords(problem, cell)}. ${facts || 'The planner knows nothing of it yet.'}`
}

/** More marks than this cannot be told apart. */
const MOST_TICKS = 200

/** A mark on the scrubber for each landmark; of those that fall on the same spot only one. */
function showTicks(ticks: HTMLElement, { steps, landmarks }: Timeline): void {
  const last = Math.max(1, steps.length - 1)
  const places = new Set<number>()
  for (const moment of landmarks) {
    const step = placeAfter(steps, moment) - 1
    places.add(Math.round((step / last) * MOST_TICKS) / MOST_TICKS)
  }
  ticks.replaceChildren(
    ...Array.from(places, (place) => create('i', { style: `left: ${place * 100}%` })),
  )
}
