import { completeParams, type ParamSettings, type ParamValue } from '../algorithms/params'
import { plannerById } from '../algorithms/plan'
import type { AnyPlanner } from '../algorithms/planner'
import { InputError } from '../grid/errors'
import { type Cell, emptyGrid, type Grid, resized } from '../grid/grid'
import { checkSize, type Problem } from '../grid/problem'
import type { DiagonalRule } from '../grid/steps'

/**
 * All that decides a plan: what the user works on, what undo and redo go through, and what survives
 * a reload. A value; every edit makes a new one.
 */
export interface Setup {
  readonly problem: Problem
  readonly plannerId: string
  /** By planner: the parameters that were set by hand, the others have their defaults. */
  readonly params: Readonly<Record<string, ParamSettings>>
  readonly seed: number
}

export const plannerOf = (setup: Setup): AnyPlanner => plannerById(setup.plannerId)

/** The settings of the chosen planner. */
export const settingsOf = (setup: Setup): ParamSettings => setup.params[setup.plannerId] ?? {}

/** All values of the chosen planner's parameters, defaults included. */
export const valuesOf = (setup: Setup): Record<string, ParamValue> =>
  completeParams(plannerOf(setup), settingsOf(setup), setup.problem)

export function withGrid(setup: Setup, grid: Grid): Setup {
  return { ...setup, problem: { ...setup.problem, grid } }
}

export function withDiagonal(setup: Setup, diagonal: DiagonalRule): Setup {
  return { ...setup, problem: { ...setup.problem, diagonal } }
}

/** The start or the goal at another cell, which has to be free. */
export function withMark(setup: Setup, mark: 'start' | 'goal', cell: Cell): Setup {
  return { ...setup, problem: { ...setup.problem, [mark]: cell } }
}

/** A parameter of a planner set by hand, or given back to its default. */
export function withParam(
  setup: Setup,
  plannerId: string,
  name: string,
  value: ParamValue | undefined,
): Setup {
  const { [name]: _, ...others } = setup.params[plannerId] ?? {}
  const settings = value === undefined ? others : { ...others, [name]: value }
  return withSettings(setup, plannerId, settings)
}

/** All settings of a planner at once. */
export function withSettings(setup: Setup, plannerId: string, settings: ParamSettings): Setup {
  return { ...setup, params: { ...setup.params, [plannerId]: settings } }
}

/** A map without obstacles, the start at its left and the goal at its right. */
export function emptyProblem(width: number, height: number, diagonal: DiagonalRule): Problem {
  checkSize(width, height)
  const middle = Math.floor((height - 1) / 2) * width
  const margin = Math.floor((width - 1) / 6)
  const [start, goal] = [middle + margin, middle + width - 1 - margin]
  return { grid: emptyGrid(width, height), start, goal, diagonal }
}

/**
 * The map cut or extended at the right and the bottom. A start or goal that is cut off, or falls on
 * an obstacle, moves to the nearest free cell.
 * @throws InputError if the size is out of bounds or no free cell is left.
 */
export function resizedProblem(problem: Problem, width: number, height: number): Problem {
  checkSize(width, height)
  const grid = resized(problem.grid, width, height)
  const moved = (cell: Cell) => {
    const x = Math.min(cell % problem.grid.width, width - 1)
    const y = Math.min(Math.floor(cell / problem.grid.width), height - 1)
    return nearestFreeCell(grid, x, y)
  }
  return { ...problem, grid, start: moved(problem.start), goal: moved(problem.goal) }
}

function nearestFreeCell(grid: Grid, x: number, y: number): Cell {
  let nearest = -1
  let least = Number.POSITIVE_INFINITY
  for (let cell = 0; cell < grid.walls.length; cell++) {
    if (grid.walls[cell]) continue
    const dx = (cell % grid.width) - x
    const dy = Math.floor(cell / grid.width) - y
    const distance = dx * dx + dy * dy
    if (distance >= least) continue
    nearest = cell
    least = distance
  }
  if (nearest < 0) {
    throw new InputError(`On ${grid.width} × ${grid.height} cells of this map no cell is free.`)
  }
  return nearest
}

/** Whether nothing was changed from one to the other; obstacles drawn anew count as a change. */
export function isSameSetup(a: Setup, b: Setup): boolean {
  const [p, q] = [a.problem, b.problem]
  return (
    p.grid === q.grid &&
    p.start === q.start &&
    p.goal === q.goal &&
    p.diagonal === q.diagonal &&
    a.plannerId === b.plannerId &&
    a.params === b.params &&
    a.seed === b.seed
  )
}
