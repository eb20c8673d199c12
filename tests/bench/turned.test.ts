import { expect, test } from 'vitest'
import { firstQueryCases } from '../../bench/planners/cases/searches'
import { faultsOn } from '../../bench/planners/check'
import { generatedMap, MAP_KINDS, RULE } from '../../bench/planners/maps'
import { parts } from '../../bench/planners/parts'
import { sturdyPeers } from '../../bench/planners/peers/all'
import { leastCost } from '../../bench/planners/plain/dijkstra'
import { allQueries, questionsOn } from '../../bench/planners/questions'
import { turnAbout } from '../../bench/planners/turned'
import { type Grid, pointOf } from '../../src/grid/grid'
import { allLegalSteps } from '../../src/grid/legal-steps'

const size = { width: 40, height: 30 }

test.each(MAP_KINDS)('on %s maps in turn no legal steps of the query before are of use', (kind) => {
  const grids: Grid[] = []
  const work = allQueries(turnAbout(generatedMap(kind, size, 1, 4)), (grid) => grids.push(grid))
  // Once more, since a sample may ask all queries again.
  expect(work() + work()).toBe(8)
  expect(grids).toHaveLength(8)
  expect(new Set(grids.map(({ height }) => height))).toEqual(new Set([30, 31]))
  let before = allLegalSteps(grids[0], RULE)
  for (const [i, grid] of grids.slice(1).entries()) {
    expect(grid.walls).not.toEqual(grids[i].walls)
    expect(grid.height).not.toBe(grids[i].height)
    const steps = allLegalSteps(grid, RULE)
    expect(steps).not.toBe(before)
    before = steps
  }
})

test.each(MAP_KINDS)('a turned %s map asks the same the other way round', (kind) => {
  const map = generatedMap(kind, size, 2, 6)
  const questions = questionsOn(turnAbout(map))
  expect(questions).toHaveLength(6)
  for (const [i, { map: asked, query }] of questions.entries()) {
    const [here, there] = [map.queries[i], query].map(({ start, goal }) =>
      [start, goal].map((cell) => pointOf(size.width, cell)),
    )
    const turn = i % 2 === 1
    expect(there).toEqual(turn ? here.map(({ x, y }) => ({ x: 39 - x, y: 29 - y })) : here)
    expect(leastCost(asked.grid, query, Math.SQRT2)).toBeCloseTo(
      leastCost(map.grid, map.queries[i], Math.SQRT2),
      9,
    )
  }
})

test.each(MAP_KINDS)('on %s maps in turn ours and the peers give shortest paths', (kind) => {
  for (let seed = 1; seed <= 5; seed++) {
    expect(faultsOn(turnAbout(generatedMap(kind, size, seed, 4)), sturdyPeers)).toEqual([])
  }
})

test('first queries are shown for each search, and held to no target', () => {
  const maps = turnAbout(generatedMap('rooms', size, 1, 4))
  const cases = firstQueryCases(maps)
  expect(cases.map(({ name }) => name)).toEqual(
    ['dijkstra', 'a-star', 'jump-point'].map(
      (search) => `first query on a map, decomposition ${search}, rooms 40×30`,
    ),
  )
  for (const { ours, peer, target } of cases) {
    expect([ours(), peer(), target]).toEqual([4, 4, null])
  }
})

test('the bench has first queries on the maps of all sizes, but for wide ones', () => {
  const small = parts.filter(({ isLarge }) => !isLarge)
  const names = small.flatMap(({ make, cases }) => cases(make()).map(({ name }) => name))
  const first = names.filter((name) => name.startsWith('first query'))
  expect(first).toHaveLength(3 * MAP_KINDS.length * 2)
  expect(parts).toHaveLength(small.length + 6 + MAP_KINDS.length)
})
