import { type Cell, cellName, type Point, pointOf } from '../../grid/grid'
import { withGrid } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { cancel, commit, edit } from '../state/transitions'
import { cellsInWords } from '../words/numbers'
import { placeOnMap } from './places'
import { lineOfCells, paint } from './stroke'
import type { Tool } from './tool'

/** Draws obstacles from a free cell on, or erases from an obstacle on. One stroke is one step to undo. */
export function drawTool(store: Store<State>, first: Cell): Tool {
  const { grid } = store.state.setup.problem
  const obstacle = grid.walls[first] === 0
  let here: Point = pointOf(grid.width, first)
  let count = 0
  let latest = first

  /** All places at once: each time that it changes, a map of millions of cells is copied. */
  const paintThrough = (places: readonly Point[]): void => {
    const { setup } = store.state
    const cells = places.flatMap((there) => {
      const line = lineOfCells(setup.problem.grid, here, there)
      here = there
      return line
    })
    const painted = paint(setup.problem, cells, obstacle)
    if (painted.changed.length === 0) return
    count += painted.changed.length
    latest = painted.changed[painted.changed.length - 1]
    store.update((state) => edit(state, withGrid(setup, painted.grid)))
  }
  paintThrough([here])

  const paintedInWords = () =>
    count === 1
      ? `${cellName(grid.width, latest)} is now ${obstacle ? 'an obstacle' : 'free'}.`
      : `${cellsInWords(count)} are now ${obstacle ? 'obstacles' : 'free'}.`

  return {
    move(places) {
      paintThrough(places.map((place) => placeOnMap(store.state.view, place)))
    },
    end: () => store.update((state) => commit(state, paintedInWords())),
    cancel: () => store.update(cancel),
  }
}
