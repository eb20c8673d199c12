import type { Outcome } from '../../algorithms/plan'
import { type Cell, isSameSize } from '../../grid/grid'
import type { Rect, ScreenSize, View } from '../../render/view'
import type { Frame } from '../../trace/frame'
import type { Tape } from '../../trace/tape'
import { type Comparison, noComparison } from '../compare/state'
import type { Tempo } from '../playback/speeds'
import type { Place } from '../playback/timeline'
import { emptyHistory, type History } from './history'
import type { WithMessages } from './messages'
import type { Preferences } from './preferences'
import type { Setup } from './setup'

/** A plan as it came from the worker, with the setup that it answers. */
export interface Shown {
  readonly setup: Setup
  readonly outcome: Outcome
  readonly tape: Tape
  /** The picture after the last event, folded in the worker. */
  readonly last: Frame
  /** Pictures on the way there, from which the others are found. */
  readonly checkpoints: readonly Frame[]
  /** How long `plan` took in the worker. */
  readonly milliseconds: number
  /** To be shown at once: it answers an edit during which the pointer was down. */
  readonly instant: boolean
}

/** What the worker is doing for the setup on screen. */
type Run =
  | { readonly kind: 'settled' }
  /** `slow` once it lasts so long that the user should know; `done` from 0 to 1. */
  | { readonly kind: 'running'; readonly slow: boolean; readonly done: number }
  | { readonly kind: 'cancelled' }
  | { readonly kind: 'failed'; readonly message: string }

/** What the last action did, for screen readers. */
export interface Said {
  readonly text: string
  /** What is said after it: the outcome, the step on screen, or what is known of the cursor's cell. */
  readonly followedBy: 'nothing' | 'outcome' | 'step' | 'cell'
}

/** The moment after the last event, however many there are. */
export const THE_END = Number.POSITIVE_INFINITY

/** All that the page shows. */
export interface State extends WithMessages {
  /** On screen: during a stroke it is ahead of `committed`, which undo and Escape go back to. */
  readonly setup: Setup
  readonly committed: Setup
  readonly history: History
  readonly shown: Shown | null
  readonly run: Run
  /** Until the next edit: `done`, no plan is drawn; `undone`, the next redo does it again. */
  readonly clearPath: 'no' | 'done' | 'undone'
  /** How many events of the plan have happened, or `THE_END`. */
  readonly time: number
  /** How the plan is being played; `null` while it is not. */
  readonly playing: Tempo | null
  /** Where the cursor was put before the map was edited; `null` after it was moved itself. */
  readonly kept: Place | null
  readonly comparison: Comparison
  readonly view: View
  /** Whether the view was fitted to the room that the cards leave, and not moved by hand since. */
  readonly fitted: boolean
  readonly screen: ScreenSize
  /** What the cards cover of the screen. */
  readonly covered: readonly Rect[]
  /** Whether the picture leaves out vertices or edges, because they are too many to be told apart. */
  readonly crowded: boolean
  /** The keyboard's cell, and whether it is on show. */
  readonly cursor: Cell
  readonly cursorShown: boolean
  /** The cell under the mouse; -1 if none. */
  readonly hovered: Cell
  readonly preferences: Preferences
  readonly said: Said
}

export type Transition = (state: State) => State

export function initialState(setup: Setup, preferences: Preferences): State {
  return {
    setup,
    committed: setup,
    history: emptyHistory,
    shown: null,
    run: { kind: 'settled' },
    clearPath: 'no',
    time: THE_END,
    playing: null,
    kept: null,
    comparison: noComparison,
    view: { scale: 1, left: 0, top: 0 },
    fitted: true,
    screen: { width: 0, height: 0 },
    covered: [],
    crowded: false,
    cursor: setup.problem.start,
    cursorShown: false,
    hovered: -1,
    preferences,
    messages: [],
    messagesTold: 0,
    said: { text: '', followedBy: 'nothing' },
  }
}

/** Whether the plan on screen answers the setup on screen. */
export function isSettled({ run, shown, setup }: State): boolean {
  return run.kind === 'settled' && shown?.setup === setup
}

/** The plan to be drawn: an older one too, as long as it lies on a map of this size. */
export function visiblePlan({ shown, run, clearPath, setup }: State): Shown | null {
  if (!shown || clearPath === 'done') return null
  if (run.kind === 'cancelled' || run.kind === 'failed') return null
  if (run.kind === 'running' && run.slow) return null
  return isSameSize(shown.tape, setup.problem.grid) ? shown : null
}

/** The cell that is asked about, with the mouse or the keyboard; -1 if none. */
export const cellAskedAbout = ({ hovered, cursor, cursorShown }: State): Cell =>
  hovered < 0 && cursorShown ? cursor : hovered
