import { expect, test } from 'vitest'
import { plannerSettings, settingName } from '../../../src/experiments/settings'
import { fieldMaps } from '../../../src/experiments/summary/fields'
import { ratioBySetting } from '../../../src/experiments/summary/ratios'
import { roadmapBySamples } from '../../../src/experiments/summary/samples'
import { wilson } from '../../../src/experiments/summary/statistics'
import { densityClass, successByDensity, successOf } from '../../../src/experiments/summary/success'
import { clockTick, estimateBelowTick, timeBySize } from '../../../src/experiments/summary/times'
import { randomNumbers } from '../../../src/grid/random'
import type { Row } from '../../../src/index'
import { rows, settings } from './rows'

const chosen = plannerSettings(settings)
const count = (test: (row: Row) => boolean) => rows.filter(test).length

test('success is counted among the maps whose goal can be reached, failures are listed', () => {
  const own = rows.filter(({ setting }) => setting === 3)
  const { rows: possible, failures, ...share } = successOf(own)
  const reached = own.filter(({ status }) => status === 'reached').length
  expect(possible.length).toBe(own.filter(({ reachable }) => reachable).length)
  expect(possible.length).toBeLessThan(own.length)
  expect(failures.length).toBe(possible.length - reached)
  expect(failures.length).toBeGreaterThan(0)
  expect(failures.every(({ status, reachable }) => reachable && status !== 'reached')).toBe(true)
  expect(share).toEqual(wilson(reached, possible.length))
})

test('a line for each planner setting, with points by increasing density', () => {
  const series = successByDensity(settings, rows)
  expect(series.map(({ name }) => name)).toEqual(chosen.map(settingName))
  for (const { setting, points } of series) {
    const densities = points.map(({ density }) => density)
    expect(densities).toEqual(densities.toSorted((a, b) => a - b))
    expect(densities).toEqual(expect.arrayContaining([10, 30]))
    let seen = 0
    for (const { density, success } of points) {
      seen += success.rows.length
      for (const row of success.rows) {
        expect(row.setting).toBe(setting)
        expect(densityClass(row)).toBe(density)
      }
    }
    expect(seen).toBe(count((row) => row.setting === setting && row.reachable))
  }
})

test('the density is the one that was asked for, else that of the map to the nearest 5 %', () => {
  const [row] = rows
  expect(densityClass({ ...row, mapParams: { density: 12 }, density: 40 })).toBe(12)
  expect(densityClass({ ...row, mapParams: { loops: 1 }, density: 42.4 })).toBe(40)
  expect(densityClass({ ...row, mapParams: {}, density: 42.6 })).toBe(45)
})

test('the ratio is that of all runs that arrived, and 1 where they are optimal', () => {
  let optimalRuns = 0
  for (const { setting, points } of ratioBySetting(settings, rows)) {
    const [{ rows: reached, optimal, quantiles }] = points
    expect(reached.length).toBe(count((row) => row.setting === setting && row.ratio !== null))
    expect(optimal).toEqual(reached.filter(({ ratio }) => ratio === 1))
    optimalRuns += optimal.length
    expect(quantiles.least).toBeGreaterThanOrEqual(1)
    expect(quantiles.greatest).toBe(Math.max(...reached.map(({ ratio }) => ratio ?? 0)))
  }
  expect(optimalRuns).toBeGreaterThan(0)
  expect(optimalRuns).toBeLessThan(count(({ ratio }) => ratio !== null))
})

test('time to plan goes by increasing size of the map', () => {
  for (const { setting, points } of timeBySize(settings, rows)) {
    expect(points.map(({ width, height, cells }) => [width, height, cells])).toEqual([
      [7, 3, 21],
      [7, 4, 28],
      [12, 9, 108],
      [20, 20, 400],
    ])
    expect(points.map(({ rows: own }) => own.length)).toEqual([12, 12, 48, 48])
    for (const { rows: own, milliseconds } of points) {
      expect(own.every((row) => row.setting === setting)).toBe(true)
      const times = own.map((row) => row.milliseconds)
      expect(times.filter((time) => time <= milliseconds.median).length * 2).toBeGreaterThanOrEqual(
        times.length,
      )
    }
  }
})

test('roadmaps: a curve for each search and cost, with points by increasing samples', () => {
  const curves = roadmapBySamples(rows)
  expect(curves.map(({ name }) => name)).toEqual([
    'search dijkstra, cost cells',
    'search dijkstra, cost euclidean',
    'search a-star, cost cells',
    'search a-star, cost euclidean',
  ])
  const maps = new Set(rows.filter(({ reachable }) => reachable).map(({ map }) => map))
  for (const { points } of curves) {
    expect(points.map(({ samples }) => samples)).toEqual([5, 40])
    const [few, many] = points
    for (const { success } of points) expect(success.rows).toHaveLength(maps.size)
    expect(few.success.rate).toBeLessThan(many.success.rate)
    expect(few.success.failures.every(({ params }) => params.samples === 5)).toBe(true)
    expect(many.milliseconds.median).toBeGreaterThan(0)
  }
})

test('potential fields: success over influence and repulsive value, holes where nothing was run', () => {
  const maps = fieldMaps(rows)
  expect(maps.map(({ name }) => name)).toEqual([
    'Potential field, manhattan',
    'Potential field, euclidean',
    'Potential field with memory, euclidean',
  ])
  const [manhattan, , memory] = maps
  expect([manhattan.influences, manhattan.repulsiveValues]).toEqual([
    [0, 2],
    [10, 30],
  ])
  manhattan.cells.forEach((line, i) => {
    line.forEach((success, k) => {
      for (const { planner, params } of success?.rows ?? []) {
        expect([planner, params]).toEqual([
          'potential-field',
          { influence: [0, 2][i], repulsiveValue: [10, 30][k], repulsionDistance: 'manhattan' },
        ])
      }
      expect(success?.rows.length).toBe(count((row) => row.setting === 0 && row.reachable))
    })
  })
  expect(memory.cells.flat()).toHaveLength(1)
  const holed = fieldMaps(
    rows.filter(({ params }) => params.influence !== 2 || params.repulsiveValue !== 30),
  )
  expect(holed[0].cells[1][1]).toBeNull()
  expect(holed[0].cells[0][1]).not.toBeNull()
})

/** Rows whose times were read off a clock with whole ticks that was started at any moment. */
function timedRows(durations: readonly number[], tick: number): Row[] {
  const random = randomNumbers(1)
  const ticksAt = (moment: number) => Math.floor(moment / tick)
  return durations.map((duration) => {
    const began = 100 * random()
    const ticks = ticksAt(began + duration) - ticksAt(began)
    return { ...rows[0], milliseconds: ticks * tick }
  })
}

test.each([0.05, 0.3, 0.8])('times of %d of a tick are estimated by how many saw one', (share) => {
  const tick = 0.1
  const durations = Array.from({ length: 4000 }, (_, i) => (i % 100 === 0 ? 50 : share * tick))
  const timed = timedRows(durations, tick)
  expect(clockTick(timed)).toBe(tick)
  const estimate = estimateBelowTick(timed, tick)
  expect(Math.abs(estimate / tick - share)).toBeLessThan(0.03)
})

test('of a clock that never ticked nothing is known', () => {
  expect(clockTick(timedRows([0, 0, 0], 1))).toBe(0)
  expect(clockTick([])).toBe(0)
})
