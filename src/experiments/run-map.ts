import { completeParams, type ParamSettings } from '../algorithms/params'
import { type Outcome, plan, plannerById } from '../algorithms/plan'
import { type Cell, type Grid, pointOf } from '../grid/grid'
import type { PathMeasure } from '../grid/path'
import type { Problem } from '../grid/problem'
import { bug1Bound, bug2Bound } from './bounds'
import type { Row } from './row'
import { type ExperimentSettings, plannerSettings } from './settings'
import { type TestMap, testMap } from './test-map'

/**
 * The rows of one map, one for each planner setting and in their order. A pure function of the
 * settings and the number, times aside: it does not matter who runs which maps, or when.
 * @param settings as `checkSettings` gave them
 * @param number of the map, from 0
 * @param now a clock in milliseconds
 * @throws InputError if the number is not such a one
 */
export function runMap(
  settings: ExperimentSettings,
  number: number,
  now: () => number = Date.now,
): Row[] {
  const map = testMap(settings, number)
  const shared = { ...describeMap(map), ...optimumOf(map.problem) }
  return plannerSettings(settings).map((chosen, setting) => {
    const { planner } = chosen
    const params = completeParams(plannerById(planner), chosen.params, map.problem)
    const began = now()
    const outcome = plan(map.problem, planner, { params, seed: map.plannerSeed })
    const milliseconds = rounded(now() - began, 3)
    return {
      ...shared,
      setting,
      planner,
      params,
      seed: map.plannerSeed,
      ...describeOutcome(outcome, params.cost === 'euclidean', shared),
      bound: boundOf(map.problem, planner, params),
      milliseconds,
    }
  })
}

function describeMap({ number, kind, seed, problem, distance, tooNear }: TestMap) {
  const { grid, start, goal } = problem
  const { width, height } = grid
  return {
    map: number,
    family: kind.family,
    mapParams: kind.params,
    width,
    height,
    density: densityOf(grid),
    mapSeed: seed,
    start: placeOf(grid, start),
    goal: placeOf(grid, goal),
    distance,
    tooNear,
  }
}

/** The least cost that there is on a map, by both rules. */
export interface Optimum {
  readonly reachable: boolean
  readonly optimumCells: number | null
  readonly optimumLength: number | null
}

export function optimumOf(problem: Problem): Optimum {
  const byCells = plan(problem, 'decomposition', { params: { cost: 'cells' } })
  if (byCells.status !== 'reached') {
    return { reachable: false, optimumCells: null, optimumLength: null }
  }
  const byLength = plan(problem, 'decomposition', { params: { cost: 'euclidean' } })
  return {
    reachable: true,
    optimumCells: byCells.measure.cells,
    optimumLength: rounded(byLength.measure.length, 6),
  }
}

function describeOutcome(
  { status, measure, expanded, sensed }: Outcome,
  byLength: boolean,
  optimum: Optimum,
) {
  const { cells, length, turns } = measure
  return {
    status,
    cells,
    length: rounded(length, 6),
    turns,
    steps: stepsOf(measure),
    ratio: ratioToOptimum({ status, measure }, byLength, optimum),
    expanded,
    sensed,
  }
}

const stepsOf = ({ cells }: PathMeasure): number => Math.max(0, cells - 1)

/** What a path cost, by length or by steps, over the least cost there is; `null` unless it reached. */
export function ratioToOptimum(
  { status, measure }: Pick<Outcome, 'status' | 'measure'>,
  byLength: boolean,
  { optimumCells, optimumLength }: Optimum,
): number | null {
  if (status !== 'reached' || optimumCells === null || optimumLength === null) return null
  const ratio = byLength ? measure.length / optimumLength : stepsOf(measure) / (optimumCells - 1)
  return rounded(ratio, 6)
}

/** Only Bug1 and Bug2 (`closer`) have one. */
export function boundOf(problem: Problem, planner: string, params: ParamSettings): number | null {
  if (planner === 'bug1')
    return bug1Bound(problem, params.turn === 'right' ? 'right' : 'left').steps
  if (planner === 'bug2' && params.leave === 'closer') return bug2Bound(problem).steps
  return null
}

function densityOf({ walls }: Grid): number {
  let obstacles = 0
  for (const wall of walls) obstacles += wall
  return rounded((100 * obstacles) / walls.length, 2)
}

function placeOf({ width }: Grid, cell: Cell): readonly [number, number] {
  const { x, y } = pointOf(width, cell)
  return [x, y]
}

/** Rows are read by people too. */
function rounded(value: number, decimals: number): number {
  return Math.round(value * 10 ** decimals) / 10 ** decimals
}
