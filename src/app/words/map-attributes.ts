import { cellName } from '../../grid/grid'
import { isSettled, type State, visiblePlan } from '../state/state'

/**
 * Data attributes of the map's element, so that tests find cells on the screen and know the state
 * without looking at pixels.
 */
export function mapAttributes(state: State): Record<string, string> {
  const { view, setup, run, cursor, cursorShown, playing } = state
  const { grid, start, goal } = setup.problem
  const name = (cell: number) => `${cell % grid.width},${Math.floor(cell / grid.width)}`
  return {
    left: String(view.left),
    top: String(view.top),
    scale: String(view.scale),
    width: String(grid.width),
    height: String(grid.height),
    start: name(start),
    goal: name(goal),
    cursor: cursorShown ? name(cursor) : '',
    planner: setup.plannerId,
    status: statusOf(state),
    cells: isSettled(state) && state.shown ? String(state.shown.outcome.path.length) : '',
    playing: String(playing !== null),
    run: run.kind,
    crowded: String(state.crowded),
  }
}

/** The outcome of the setup on screen, or why there is none. */
function statusOf(state: State): string {
  if (state.run.kind === 'cancelled' || state.run.kind === 'failed') return state.run.kind
  if (!isSettled(state) || !state.shown) return 'planning'
  return visiblePlan(state) ? state.shown.outcome.status : 'hidden'
}

/** "Map of 49 × 23 cells, start at (3, 5), goal at (44, 5)". */
export function mapLabel({ setup }: State): string {
  const { grid, start, goal } = setup.problem
  const [from, to] = [cellName(grid.width, start), cellName(grid.width, goal)]
  return `Map of ${grid.width} × ${grid.height} cells, start at ${from}, goal at ${to}`
}
