import { messageOf } from '../../grid/errors'
import { type Cell, emptyGrid, isSameSize } from '../../grid/grid'
import { fitView, keepOnScreen, type Rect, type ScreenSize, type View } from '../../render/view'
import { roomForMap } from '../layout/room'
import { cursorOn, endWelcome } from '../playback/arrival'
import type { Tempo } from '../playback/speeds'
import * as history from './history'
import { tellOfMap, withoutErrors, withoutThoseOfMap } from './messages'
import type { Preferences } from './preferences'
import { isSameSetup, plannerOf, type Setup, withGrid } from './setup'
import { type Shown, type State, THE_END } from './state'

// Transitions are pure: each makes the next state from the last one.

/** Shows an edit that may still go on, as during a stroke. */
export function edit(state: State, setup: Setup): State {
  if (setup === state.setup) return state
  const { grid, start } = setup.problem
  const messages = withoutThoseOfMap(state.messages)
  const edited = { ...endWelcome(state), setup, clearPath: 'no' as const, messages }
  if (isSameSize(grid, state.setup.problem.grid)) return edited
  return fitToRoom({ ...edited, cursor: start, cursorShown: false, hovered: -1 })
}

/** Makes all edits since the last commit one step to undo. */
export function commit(state: State, text: string): State {
  if (state.setup === state.committed) return state
  // A mark that was dragged away and back.
  if (isSameSetup(state.setup, state.committed)) return cancel(state)
  return {
    ...state,
    history: history.remember(state.history, state.committed),
    committed: state.setup,
    said: { text, followedBy: 'outcome' },
    // Who has changed something needs no greeting any more.
    preferences: prefer(state, { hint: false }).preferences,
  }
}

/** Takes back all edits since the last commit. */
export const cancel = (state: State): State => edit(state, state.committed)

/** An edit that is a step of its own. */
export function change(state: State, setup: Setup, text: string): State {
  return commit(edit(commit(state, ''), setup), text)
}

export function clearObstacles(state: State): State {
  const { width, height, walls } = state.setup.problem.grid
  if (!walls.includes(1)) return say(state, 'There are no obstacles.')
  const cleared = withGrid(state.setup, emptyGrid(width, height))
  return change(state, cleared, 'All obstacles are cleared.')
}

/** Tries a change that may throw. If it does, all stays as it was, and a message says why. */
export function attempt(state: State, transition: (state: State) => State): State {
  try {
    return transition(state)
  } catch (error) {
    return tellOfMap(state, 'error', messageOf(error))
  }
}

/**
 * A change to another map: all of it is shown, with the end of its plan. Errors of earlier attempts to
 * open one are taken away.
 */
export function changeMap(state: State, setup: Setup, text: string): State {
  const changed = change(state, setup, text)
  const messages = withoutErrors(changed.messages)
  return fitToRoom({ ...changed, messages, time: THE_END, playing: null, kept: null })
}

export function undo(state: State): State {
  if (state.clearPath === 'done') {
    return say({ ...state, clearPath: 'undone' }, 'The path is shown again.')
  }
  return travel(state, history.undo, { done: 'Undone.', nothing: 'Nothing to undo.' })
}

export function redo(state: State): State {
  if (state.clearPath === 'undone') return hidePath(state)
  return travel(state, history.redo, { done: 'Redone.', nothing: 'Nothing to redo.' })
}

interface TravelWords {
  readonly done: string
  readonly nothing: string
}

function travel(state: State, to: typeof history.undo, words: TravelWords): State {
  // During a stroke there is nothing else to undo than the stroke.
  if (state.setup !== state.committed) return cancel(state)
  const arrived = to(state.history, state.setup)
  if (!arrived) return say(state, words.nothing)
  return {
    ...edit(state, arrived.setup),
    committed: arrived.setup,
    history: arrived.history,
    said: { text: words.done, followedBy: 'outcome' },
  }
}

/** A run that replaces a slow one is slow from its beginning: the plan before both stays hidden. */
export const planStarted = (state: State): State => ({
  ...state,
  run: { kind: 'running', slow: state.run.kind === 'running' && state.run.slow, done: 0 },
})

export function planProgressed(state: State, done: number): State {
  return state.run.kind === 'running' ? { ...state, run: { ...state.run, done } } : state
}

export function planIsSlow(state: State): State {
  const { run } = state
  return run.kind === 'running' && !run.slow ? { ...state, run: { ...run, slow: true } } : state
}

/** @param welcome how it is played if it is shown from its beginning; `null` for its end at once */
export function planArrived(state: State, shown: Shown, welcome: Tempo | null = null): State {
  const isWanted = shown.setup === state.setup
  const arrived = { ...state, shown, ...cursorOn(state, shown, welcome) }
  return isWanted ? ended(arrived, { kind: 'settled' }) : arrived
}

/** The plan on screen is that of the setup: an edit was taken back before another plan was there. */
export const planStands = (state: State): State => ({ ...state, run: { kind: 'settled' } })

/** There is no plan for this setup. For a setup that is not on screen any more, nothing is said. */
export function planFailed(state: State, setup: Setup, message: string): State {
  return setup === state.setup ? ended(state, { kind: 'failed', message }) : state
}

export const planCancelled = (state: State): State => ended(state, { kind: 'cancelled' })

/** After a wait, what came of it is said, even if something else was said meanwhile. */
function ended(state: State, run: State['run']): State {
  const { text, followedBy } = state.said
  const isOwed = state.run.kind === 'running' && state.run.slow && text && followedBy !== 'outcome'
  return { ...(isOwed ? sayOutcome(state) : state), run }
}

/** Once there is a plan for what is on screen, what came of it is said. */
export const sayOutcome = (state: State): State => ({
  ...state,
  said: { text: `Planner: ${plannerOf(state.setup).title}.`, followedBy: 'outcome' },
})

export const PATH_HIDDEN = 'The path is hidden until the next change; undo shows it again.'

export const hidePath = (state: State): State =>
  say({ ...state, clearPath: 'done', playing: null }, PATH_HIDDEN)

export const look = (state: State, view: View): State => ({ ...state, view, fitted: false })

/** The whole map in the room that the cards leave. */
export function fitToRoom(state: State): State {
  const { screen, covered, setup } = state
  if (screen.width === 0) return { ...state, fitted: true }
  const { grid } = setup.problem
  return { ...state, view: fitView(grid, roomForMap(screen, covered, grid)), fitted: true }
}

/**
 * The window or the cards have another size or place. A fitted view is fitted anew only if that was
 * the user's doing: a map that moves because a text beside it grew is a nuisance.
 */
export function layOut(
  state: State,
  screen: ScreenSize,
  covered: readonly Rect[],
  byUser: boolean,
): State {
  const laidOut = { ...state, screen, covered }
  if (state.fitted) return byUser ? fitToRoom(laidOut) : laidOut
  return { ...laidOut, view: keepOnScreen(state.view, state.setup.problem.grid, screen) }
}

export const crowd = (state: State, crowded: boolean): State =>
  crowded === state.crowded ? state : { ...state, crowded }

export const moveCursor = (state: State, cursor: Cell): State => ({
  ...state,
  cursor,
  cursorShown: true,
  // The mouse may still be on the map, but now the cell of interest is the cursor's.
  hovered: -1,
})

export const hover = (state: State, hovered: Cell): State =>
  hovered === state.hovered ? state : { ...state, hovered }

/** The cursor goes out of sight; it comes back at `cell`. */
export const hideCursor = (state: State, cursor = state.cursor): State => ({
  ...state,
  cursor,
  cursorShown: false,
})

export function prefer(state: State, some: Partial<Preferences>): State {
  const preferences = { ...state.preferences, ...some }
  const isNew = JSON.stringify(preferences) !== JSON.stringify(state.preferences)
  return isNew ? { ...state, preferences } : state
}

/** Said by screen readers, and shown nowhere. */
export const say = (state: State, text: string): State => ({
  ...state,
  said: { text, followedBy: 'nothing' },
})

/** Said of the cursor's cell, with what the planner knows of it. */
export const sayOfCell = (state: State, text: string): State => ({
  ...state,
  said: { text, followedBy: 'cell' },
})
