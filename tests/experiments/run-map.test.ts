import { expect, test } from 'vitest'
import { boundOf } from '../../src/experiments/run-map'
import {
  bug1Bound,
  checkSettings,
  countWork,
  type ExperimentSettings,
  plan,
  plannerById,
  planners,
  problemFromText,
  type Row,
  runMap,
  testMap,
} from '../../src/index'
import { lengthOf, shortestWay } from '../reference/shortest'
import type { World } from '../reference/world'
import { settingsWith, timeless } from './settings'

const rowsOf = (settings: ExperimentSettings): Row[] =>
  Array.from({ length: countWork(settings).maps }, (_, number) =>
    runMap(settings, number, () => performance.now()),
  ).flat()

function worldOf(settings: ExperimentSettings, number: number): World {
  const { grid, start, goal, diagonal } = testMap(settings, number).problem
  const { width, height, walls } = grid
  const rows = Array.from({ length: height }, (_, y) =>
    Array.from(walls.subarray(y * width, (y + 1) * width), (wall) => (wall ? '#' : '.')).join(''),
  )
  const place = (cell: number) => [cell % width, Math.floor(cell / width)] as const
  return { width, height, rows, start: place(start), goal: place(goal), rule: diagonal }
}

const settings = settingsWith({ mapsPerCombination: 5 })
const rows = rowsOf(settings)

test('a row for each planner setting on each map, in order, the same each time', () => {
  expect(rows).toHaveLength(50 * 12)
  rows.forEach(({ map, setting }, i) => {
    expect([map, setting]).toEqual([Math.floor(i / 12), i % 12])
  })
  expect(timeless(runMap(settings, 13))).toEqual(timeless(rows).slice(13 * 12, 14 * 12))
})

test('the clock is all that is timed', () => {
  let time = 0
  const ticking = runMap(settings, 1, () => (time += 2.5))
  expect(ticking.map(({ milliseconds }) => milliseconds)).toEqual(new Array(12).fill(2.5))
})

test('the optimum is that of brute force, and so is the ratio', () => {
  let reachable = 0
  for (const row of rows) {
    const world = worldOf(settings, row.map)
    const least = shortestWay(world, 'cells')
    const shortest = shortestWay(world, 'euclidean')
    expect(row.reachable).toBe(least !== undefined)
    if (!least || !shortest) {
      expect([row.optimumCells, row.optimumLength, row.ratio]).toEqual([null, null, null])
      continue
    }
    reachable++
    expect(row.optimumCells).toBe(least.steps + 1)
    expect(row.optimumLength).toBeCloseTo(lengthOf(shortest), 5)
    if (row.status !== 'reached') expect(row.ratio).toBeNull()
    else if (row.params.cost === 'euclidean') {
      expect(row.ratio).toBeCloseTo(row.length / lengthOf(shortest), 5)
    } else expect(row.ratio).toBeCloseTo((row.cells - 1) / least.steps, 5)
    if (row.planner === 'decomposition') expect(row.ratio).toBeCloseTo(1, 6)
  }
  expect(reachable).toBeGreaterThan(300)
  expect(reachable).toBeLessThan(rows.length)
})

test('complete planners succeed wherever the goal can be reached, and prove the rest', () => {
  const all = checkSettings({
    ...settings,
    planners: [
      ...planners.map(({ id }) => ({ planner: id })),
      { planner: 'bug2', params: { leave: ['closer'] } },
      { planner: 'tangent-bug', params: { variant: ['classic'] } },
    ],
  })
  const complete = new Set<string>()
  for (const { planner, params, reachable, status } of rowsOf(all)) {
    if (!plannerById(planner).complete(params)) expect(status).not.toBe('unreachable')
    else {
      expect(status).toBe(reachable ? 'reached' : 'unreachable')
      complete.add(planner)
    }
  }
  const known = ['decomposition', 'visibility-graph', 'bug1', 'bug2', 'tangent-bug']
  expect([...complete]).toEqual(expect.arrayContaining(known))
})

test('bug1 and bug2 (closer) have a bound and keep it, the others have none', () => {
  for (const { planner, params, bound, steps } of rows) {
    const isBounded = planner === 'bug1' || params.leave === 'closer'
    if (!isBounded) expect(bound).toBeNull()
    else expect(steps).toBeLessThanOrEqual(bound ?? -1)
  }
})

test('the bound of bug1 is that for the side on which it keeps obstacles', () => {
  // Two places of the wall are as near to the goal: which one comes first is up to the turn.
  const problem = problemFromText(`
    ................
    ...##...........
    ...#............
    ...#............
    ...#............
    S..#..........G.
    ...#............
    ...#..###.......
    ...#..###.......
    ...##...........
    ................
  `)
  const bounds = (['left', 'right'] as const).map((turn) => {
    const { steps } = bug1Bound(problem, turn)
    expect(boundOf(problem, 'bug1', { turn })).toBe(steps)
    expect(plan(problem, 'bug1', { params: { turn } }).measure.cells - 1).toBeLessThanOrEqual(steps)
    return steps
  })
  expect(bounds[0]).not.toBe(bounds[1])
})

test('a row is enough to run it again', () => {
  for (const row of rows.filter(({ map }) => map < 10)) {
    const { problem } = testMap(settings, row.map)
    const { status, measure, expanded, sensed } = plan(problem, row.planner, row)
    expect([status, measure.cells, measure.turns, expanded, sensed]).toEqual([
      row.status,
      row.cells,
      row.turns,
      row.expanded,
      row.sensed,
    ])
    expect(measure.length).toBeCloseTo(row.length, 5)
    expect(row.start).toEqual(worldOf(settings, row.map).start)
    expect(row.steps).toBe(Math.max(0, row.cells - 1))
    const { walls } = problem.grid
    const obstacles = walls.filter((wall) => wall === 1).length
    expect(row.density).toBeCloseTo((100 * obstacles) / walls.length, 1)
  }
})
