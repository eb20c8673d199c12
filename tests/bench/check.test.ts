import { expect, test } from 'vitest'
import { faultsOn } from '../../bench/planners/check'
import { roadmapFaultsOn } from '../../bench/planners/check-roadmap'
import { checkInWords, isOursRight, together } from '../../bench/planners/checked'
import { generatedMap, MAP_KINDS } from '../../bench/planners/maps'
import { allPeers } from '../../bench/planners/peers/all'
import { easystar } from '../../bench/planners/peers/easystar'
import { ngraphAStarBuilt } from '../../bench/planners/peers/ngraph'
import {
  pathfindingBiAStar,
  pathfindingJumpPointDefault,
} from '../../bench/planners/peers/pathfinding'

const size = { width: 40, height: 30 }
const WRONG = [easystar, pathfindingBiAStar, pathfindingJumpPointDefault]

test.each(MAP_KINDS)('on %s maps ours and most peers give shortest paths', (kind) => {
  const peers = [...allPeers.filter((peer) => !WRONG.includes(peer)), ngraphAStarBuilt]
  for (let seed = 1; seed <= 5; seed++) {
    expect(faultsOn([generatedMap(kind, size, seed, 3)], peers)).toEqual([])
  }
})

test.each(MAP_KINDS)('on %s maps our roadmaps have the edges that walking finds', (kind) => {
  expect(roadmapFaultsOn(generatedMap(kind, size, 2, 2))).toEqual([])
})

test.each(WRONG)('$name gives paths that are legal, but some are too long', (peer) => {
  const faults = Array.from({ length: 20 }, (_, i) =>
    faultsOn([generatedMap('random', size, i + 1, 4)], [peer]),
  ).flat()
  expect(faults.length).toBeGreaterThan(0)
  expect(faults.length).toBeLessThan(80)
  for (const { who, isOurs, cost, least } of faults) {
    expect([who, isOurs]).toEqual([peer.name, false])
    expect(cost).toBeGreaterThan(least)
  }
})

test('who is wrong is told, and only ours count', () => {
  const map = generatedMap('open', size, 1, 2)
  const cut = { name: 'a wall walker', on: () => () => [] }
  const thrower = {
    name: 'a thrower',
    on: () => () => {
      throw new Error('no stack left')
    },
  }
  const faults = faultsOn([map], [cut, thrower])
  expect(faults.map(({ who, cost }) => [who, cost])).toEqual([
    ['a wall walker', Number.NaN],
    ['a wall walker', Number.NaN],
    ['a thrower', Number.NaN],
    ['a thrower', Number.NaN],
  ])
  const checked = together([
    { queries: 2, faults },
    { queries: 3, faults: [] },
  ])
  expect(isOursRight(checked)).toBe(true)
  const [first, second, third, ...peers] = checkInWords(checked)
  expect(first).toContain('5 queries')
  expect([second, third]).toEqual([
    'Ours are right by every search.',
    'Peers that give wrong lengths:',
  ])
  expect(peers[0]).toMatch(
    /a wall walker: 2 wrong; worst no legal path.* on open 40×30, seed 1, \(/,
  )
  expect(peers[1]).toContain('no stack left')
  const ours = { queries: 1, faults: [{ ...faults[0], isOurs: true, cost: 50, least: 40 }] }
  expect(isOursRight(together([checked, ours]))).toBe(false)
  expect(checkInWords(ours)[1]).toBe('WRONG, OURS:')
  expect(checkInWords(ours)[2]).toContain('25 % too long')
})
