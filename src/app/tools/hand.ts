import { type Cell, cellName, type Point } from '../../grid/grid'
import { cellAt } from '../../render/view'
import { tellOfMap } from '../state/messages'
import { withMark } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { change, hideCursor } from '../state/transitions'
import { drawTool } from './draw'
import { moveMarkTool } from './move-mark'
import { Pinch, panTool } from './pan'
import { gripAt } from './stroke'
import type { Tool } from './tool'

/** A pointer as the listeners see it; places are CSS pixels from the top left of the map's element. */
export interface Press {
  readonly id: number
  readonly place: Point
  readonly button: 'main' | 'middle' | 'right'
  readonly isTouch: boolean
}

/** Decides what a press means and leads the tool from there on. Knows no events. */
export class Hand {
  /** Space is held down: the next press takes hold of the map. */
  spaceHeld = false
  /** Whether the map was dragged since Space went down. */
  spaceUsed = false
  readonly #store: Store<State>
  readonly #fingers = new Map<number, Point>()
  #tool: { readonly id: number; readonly tool: Tool } | null = null
  #pinch: Pinch | null = null
  #nextMark: 'start' | 'goal' = 'start'

  constructor(store: Store<State>) {
    this.#store = store
    // Something else was changed, as by a file that has been read: a stroke does not go on upon it.
    store.subscribe((now, before) => {
      if (now.committed === before.committed) return
      this.#tool = null
      this.#pinch = null
    })
  }

  get isBusy(): boolean {
    return this.#tool !== null || this.#pinch !== null
  }

  press({ id, place, button, isTouch }: Press): void {
    if (isTouch) {
      this.#fingers.set(id, place)
      if (this.#fingers.size > 1) {
        this.#startPinch()
        return
      }
    }
    if (this.isBusy) return
    const cell = this.#cellAt(place)
    this.#store.update((state) => hideCursor(state, cell < 0 ? undefined : cell))
    if (button === 'right') this.#setNextMark(cell)
    else this.#tool = { id, tool: this.#toolFor(button, place, cell) }
  }

  move(id: number, places: readonly Point[]): void {
    if (places.length === 0) return
    if (this.#fingers.has(id)) this.#fingers.set(id, places[places.length - 1])
    const [a, b] = this.#fingers.values()
    if (this.#pinch) this.#pinch.move(a, b)
    else if (this.#tool?.id === id) this.#tool.tool.move(places)
  }

  /** @param completed false if the pointer was taken away, by the system or by a gesture */
  release(id: number, completed: boolean): void {
    if (this.#fingers.delete(id)) this.#pinch = null
    if (this.#tool?.id === id) this.#endTool(completed)
  }

  /** Breaks off what is under way; returns whether there was anything. */
  cancel(): boolean {
    if (!this.#tool) return false
    this.#endTool(false)
    return true
  }

  #endTool(completed: boolean): void {
    const tool = this.#tool?.tool
    this.#tool = null
    if (completed) tool?.end()
    else tool?.cancel()
  }

  #cellAt(place: Point): Cell {
    const { view, setup } = this.#store.state
    return cellAt(view, setup.problem.grid, place.x, place.y)
  }

  #toolFor(button: 'main' | 'middle', place: Point, cell: Cell): Tool {
    const grip = gripAt(this.#store.state.setup.problem, cell)
    if (this.spaceHeld) this.spaceUsed = true
    if (button === 'middle' || this.spaceHeld || grip === 'outside') {
      return panTool(this.#store, place)
    }
    return grip === 'start' || grip === 'goal'
      ? moveMarkTool(this.#store, grip)
      : drawTool(this.#store, cell)
  }

  /** What the first finger has drawn meanwhile was not meant. Of three fingers the first two count. */
  #startPinch(): void {
    this.cancel()
    const [a, b] = this.#fingers.values()
    this.#pinch ??= new Pinch(this.#store, a, b)
  }

  #setNextMark(cell: Cell): void {
    if (cell < 0) return
    const mark = this.#nextMark
    const { setup } = this.#store.state
    const name = cellName(setup.problem.grid.width, cell)
    if (setup.problem.grid.walls[cell]) {
      const text = `The ${mark} cannot be set at ${name}: an obstacle is there.`
      this.#store.update((state) => tellOfMap(state, 'note', text))
      return
    }
    this.#nextMark = mark === 'start' ? 'goal' : 'start'
    this.#store.update((state) =>
      change(state, withMark(setup, mark, cell), `The ${mark} is now at ${name}.`),
    )
  }
}
