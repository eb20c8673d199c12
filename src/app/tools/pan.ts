import type { Point } from '../../grid/grid'
import { panBy, type View, zoomAt } from '../../render/view'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { look } from '../state/transitions'
import type { Tool } from './tool'

/** Drags the map about. */
export function panTool(store: Store<State>, from: Point): Tool {
  const before = store.state.view
  let here = from
  return {
    move(places) {
      const there = places[places.length - 1]
      store.update((state) => {
        const { grid } = state.setup.problem
        return look(
          state,
          panBy(state.view, there.x - here.x, there.y - here.y, grid, state.screen),
        )
      })
      here = there
    },
    end() {},
    cancel: () => store.update((state) => look(state, before)),
  }
}

/**
 * Two fingers: the map follows both, so that it can be moved and zoomed at once. All is reckoned from
 * where they were put down, since they are told of one by one: of a zoom that on the way to both was
 * too large a part would be missing from then on.
 */
export class Pinch {
  readonly #store: Store<State>
  readonly #view: View
  readonly #middle: Point
  readonly #distance: number

  constructor(store: Store<State>, a: Point, b: Point) {
    this.#store = store
    this.#view = store.state.view
    this.#middle = middleOf(a, b)
    this.#distance = distanceOf(a, b)
  }

  move(a: Point, b: Point): void {
    const { x, y } = this.#middle
    const middle = middleOf(a, b)
    const factor = distanceOf(a, b) / this.#distance
    this.#store.update((state) => {
      const { grid } = state.setup.problem
      const zoomed = zoomAt(this.#view, factor, x, y, grid)
      return look(state, panBy(zoomed, middle.x - x, middle.y - y, grid, state.screen))
    })
  }
}

const middleOf = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 })

const LEAST_DISTANCE = 8

const distanceOf = (a: Point, b: Point): number =>
  Math.max(LEAST_DISTANCE, Math.hypot(a.x - b.x, a.y - b.y))
