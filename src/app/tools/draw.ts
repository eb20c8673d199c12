import { type Cell, cellName, type Point, pointOf } from '../../grid/grid'
import { withGrid } from '../setup'
import type { State } from '../state'
import type { Store } from '../store'
import { cancel, commit, edit } from '../transitions'
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

  const paintTo = (there: Point): void => {
    const { setup } = store.state
    const painted = paint(setup.problem, lineOfCells(setup.problem.grid, here, there), obstacle)
    here = there
    if (painted.changed.length === 0) return
    count += painted.changed.length
    latest = painted.changed[painted.changed.length - 1]
    store.update((state) => edit(state, withGrid(setup, painted.grid)))
  }
  paintTo(here)

  return {
    move(places) {
      for (const place of places) paintTo(placeOnMap(store.state.view, place))
    },
    end: () => store.update((state) => commit(state, paintedInWords(grid.width))),
    cancel: () => store.update(cancel),
  }

  function paintedInWords(width: number): string {
    if (count !== 1) return `${count} cells are now ${obstacle ? 'obstacles' : 'free'}.`
    return `${cellName(width, latest)} is now ${obstacle ? 'an obstacle' : 'free'}.`
  }
}
