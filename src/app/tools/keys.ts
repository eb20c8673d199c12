import { type Direction, DX, DY } from '../../grid/directions'
import { type Cell, cellName, type Grid, isInside, pointOf } from '../../grid/grid'
import { cellRect, panBy, type Rect, type ScreenSize, type View, zoomAt } from '../../render/view'
import { roomForMap } from '../layout/room'
import { tellOfMap } from '../state/messages'
import { withGrid, withMark } from '../state/setup'
import type { State, Transition } from '../state/state'
import {
  change,
  fitToRoom,
  hideCursor,
  look,
  moveCursor,
  redo,
  say,
  sayOfCell,
  undo,
} from '../state/transitions'
import { cellInWords } from '../words/cell-line'
import { gripAt, paint } from './stroke'

/** A key with its modifiers, as far as they matter. `command` is Ctrl, on a Mac ⌘ as well. */
export interface KeyPress {
  readonly key: string
  readonly command: boolean
  readonly shift: boolean
}

const ARROWS: Readonly<Record<string, Direction>> = {
  ArrowUp: 0,
  ArrowRight: 2,
  ArrowDown: 4,
  ArrowLeft: 6,
}

export const ZOOM_STEP = 1.25

/** What a key does on the whole page; `null` if nothing. */
export function pageKey({ key, command, shift }: KeyPress): Transition | null {
  if (!command) return null
  const letter = key.toLowerCase()
  if (letter === 'z') return shift ? redo : undo
  return letter === 'y' ? redo : null
}

/**
 * What a key does while the map has the focus; `null` if nothing. Space counts when it goes up.
 * Without a cursor, Space and the arrows along the time line are for the playback, as everywhere.
 */
export function mapKey({ key, command, shift }: KeyPress, cursorShown: boolean): Transition | null {
  if (command) return null
  const direction = ARROWS[key]
  const isSideways = key === 'ArrowLeft' || key === 'ArrowRight'
  if (isSideways && (shift || !cursorShown)) return null
  if (direction !== undefined) return (state) => moved(state, direction)
  switch (key) {
    case 'Enter':
      return toggled
    case ' ':
      return cursorShown ? toggled : null
    case 's':
    case 'S':
      return (state) => marked(state, 'start')
    case 'g':
    case 'G':
      return (state) => marked(state, 'goal')
    case '+':
    case '=':
      return (state) => zoomed(state, ZOOM_STEP)
    case '-':
      return (state) => zoomed(state, 1 / ZOOM_STEP)
    case '0':
      return wholeMapShown
    case 'Escape':
      return cursorHidden
    default:
      return null
  }
}

/** Zooms at the cursor if it is on show, else at the middle of the room for the map. */
export function zoomed(state: State, factor: number): State {
  const { view, cursor, cursorShown, screen, covered, setup } = state
  const { grid } = setup.problem
  const rect = cursorShown ? cellRect(view, grid, cursor) : roomForMap(screen, covered, grid)
  const [x, y] = [rect.left + rect.width / 2, rect.top + rect.height / 2]
  const text = factor > 1 ? 'Zoomed in.' : 'Zoomed out.'
  return say(look(state, zoomAt(view, factor, x, y, grid)), text)
}

export const wholeMapShown = (state: State): State =>
  say(fitToRoom(state), 'The whole map is shown.')

/** Said because Space and arrows do something else from now on. */
const cursorHidden = (state: State): State =>
  state.cursorShown ? say(hideCursor(state), 'The cursor is hidden.') : state

function moved(state: State, direction: Direction): State {
  const { grid } = state.setup.problem
  const { x, y } = pointOf(grid.width, state.cursor)
  const [toX, toY] = [x + DX[direction], y + DY[direction]]
  const cell = isInside(grid, toX, toY) ? toY * grid.width + toX : state.cursor
  const edge = cell === state.cursor ? 'Edge of the map. ' : ''
  const text = `${edge}${cellInWords(state.setup.problem, cell)}.`
  return sayOfCell(revealed(moveCursor(state, cell)), text)
}

/** The view moved as little as shows the cursor, clear of the cards. */
function revealed(state: State): State {
  const { view, cursor, screen, covered, setup } = state
  const { grid } = setup.problem
  const there = reveal(view, grid, cursor, roomForMap(screen, covered, grid), screen)
  return there === view ? state : look(state, there)
}

/** The view moved as little as brings a cell, and some of what is around it, into `room`. */
export function reveal(view: View, grid: Grid, cell: Cell, room: Rect, screen: ScreenSize): View {
  const rect = cellRect(view, grid, cell)
  const shift = (start: number, size: number, from: number, length: number) => {
    const margin = Math.min(2 * size, Math.max(0, (length - size) / 2))
    const missingBefore = Math.max(0, from + margin - start)
    const missingAfter = Math.max(0, start + size - (from + length - margin))
    return missingBefore > 0 ? missingBefore : -missingAfter
  }
  // The margin is asked for only where the cell itself is hidden: a fitted map has none.
  const hidden =
    rect.left < room.left ||
    rect.top < room.top ||
    rect.left + rect.width > room.left + room.width ||
    rect.top + rect.height > room.top + room.height
  if (!hidden) return view
  const dx = shift(rect.left, rect.width, room.left, room.width)
  const dy = shift(rect.top, rect.height, room.top, room.height)
  return panBy(view, dx, dy, grid, screen)
}

/** Nothing is changed at a cell that nobody sees. */
function cursorShown(state: State): State {
  const text = `${cellInWords(state.setup.problem, state.cursor)}.`
  return sayOfCell(revealed(moveCursor(state, state.cursor)), text)
}

function toggled(state: State): State {
  const { setup, cursor } = state
  if (!state.cursorShown) return cursorShown(state)
  const { problem } = setup
  const grip = gripAt(problem, cursor)
  const name = cellName(problem.grid.width, cursor)
  if (grip === 'start' || grip === 'goal') {
    return tellOfMap(state, 'note', `${name} is the ${grip}: no obstacle can be there.`)
  }
  const obstacle = grip === 'free'
  const { grid } = paint(problem, [cursor], obstacle)
  const text = `${name} is now ${obstacle ? 'an obstacle' : 'free'}.`
  return change(state, withGrid(setup, grid), text)
}

function marked(state: State, mark: 'start' | 'goal'): State {
  const { setup, cursor } = state
  const { grid } = setup.problem
  const name = cellName(grid.width, cursor)
  if (!state.cursorShown) return cursorShown(state)
  if (grid.walls[cursor]) {
    return tellOfMap(state, 'note', `${name} is an obstacle: the ${mark} cannot be there.`)
  }
  if (setup.problem[mark] === cursor) return say(state, `The ${mark} is at ${name} already.`)
  return change(state, withMark(setup, mark, cursor), `The ${mark} is now at ${name}.`)
}
