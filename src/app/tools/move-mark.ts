import { cellName, type Point, pointOf } from '../../grid/grid'
import { withMark } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { cancel, commit, edit } from '../state/transitions'
import { placeOnMap } from './places'
import { lineOfCells } from './stroke'
import type { Tool } from './tool'

/** Drags the start or the goal; over obstacles and outside the map it stays at the last free cell. */
export function moveMarkTool(store: Store<State>, mark: 'start' | 'goal'): Tool {
  const { grid } = store.state.setup.problem
  let here: Point = pointOf(grid.width, store.state.setup.problem[mark])

  const moveTo = (there: Point): void => {
    const { setup } = store.state
    const free = lineOfCells(grid, here, there).filter((cell) => grid.walls[cell] === 0)
    here = there
    const cell = free.at(-1)
    if (cell === undefined || cell === setup.problem[mark]) return
    store.update((state) => edit(state, withMark(setup, mark, cell)))
  }

  return {
    move(places) {
      for (const place of places) moveTo(placeOnMap(store.state.view, place))
    },
    end: () =>
      store.update((state) => {
        const where = cellName(grid.width, state.setup.problem[mark])
        return commit(state, `The ${mark} is now at ${where}.`)
      }),
    cancel: () => store.update(cancel),
  }
}
