import { expect, test } from 'vitest'
import type { Case } from '../../bench/planners/case'
import { speedDocument } from '../../bench/planners/document'
import { byContender } from '../../bench/planners/faults'
import { type Growth, growers, isGrowthMet } from '../../bench/planners/growth'
import { generatedMap } from '../../bench/planners/maps'
import { columnsOf, digits, growthInWords } from '../../bench/planners/words'

const one: Case = {
  name: 'decomposition dijkstra, open 60×40',
  against: 'a peer',
  ours: () => 1,
  peer: () => 1,
  unit: 'query',
  target: { atLeast: 12 },
}
const figures = { ours: 0.0512, peer: 1.25, ratio: 24.4, lower: 20, upper: 30, met: true }

const growthTo = (exponent: number): Growth[] =>
  growers.map((grower) => ({
    grower,
    exponent,
    points: [64, 512, 2048].map((side) => ({ side, least: 1, median: side, greatest: 9000 })),
  }))

const measured = {
  checked: { queries: 1200, faults: [] },
  results: [{ one, figures }],
  growth: growthTo(1),
  machine: 'a machine',
}

test('a case is one line: times, ratio, spread, target and whether it is met', () => {
  expect(columnsOf(one, figures)).toEqual([
    'decomposition dijkstra, open 60×40',
    '0.0512 ms',
    '1.25 ms',
    'a peer',
    '24.4×',
    '20–30',
    '≥ 12',
    'met',
  ])
  const cell: Case = { ...one, unit: 'cell', target: { atMost: 4 } }
  expect(columnsOf(cell, { ...figures, ours: 0.0000512, met: false })).toMatchObject({
    1: '51.2 ns',
    6: '≤ 4',
    7: 'MISSED',
  })
  expect(columnsOf({ ...one, target: null }, figures).slice(6)).toEqual(['–', ''])
  expect(digits(52_811)).toBe('52,800')
})

test('growth is bound for decomposition by dijkstra and for potential fields', () => {
  const bound = growers.filter(({ isLinear }) => isLinear).map(({ name }) => name)
  expect(bound).toEqual(['decomposition dijkstra', 'potential-field'])
  expect(growthTo(1).every(isGrowthMet)).toBe(true)
  expect(growthTo(1.5).filter(isGrowthMet)).toHaveLength(growers.length - 2)
  expect(growthInWords(growthTo(1)[0])).toBe(
    'growth of decomposition dijkstra: 64 ms at 64×64, 2,050 ms at 2048×2048: cells^1.00, a doubling takes ×2 (≤ 2.3: met)',
  )
})

test('the document has all cases, all planners and the drawings that it shows', () => {
  const missed = { one: { ...one, name: 'another' }, figures: { ...figures, met: false } }
  const { markdown, figures: drawings } = speedDocument(
    { ...measured, results: [{ one, figures }, missed] },
    'speed',
  )
  expect(markdown).toContain('1 of 2 targets are met')
  expect(markdown).toContain(
    '| decomposition dijkstra, open 60×40 | 0.0512 ms | 1.25 ms | a peer |',
  )
  expect(markdown).toContain('Measured with a machine.')
  for (const { name } of growers) expect(markdown).toContain(`| ${name} |`)
  expect(drawings).toHaveLength(2)
  for (const { name, svg } of drawings) {
    expect(markdown).toContain(`(speed/${name}.svg)`)
    expect(svg).toMatch(/^<svg [^>]*>/)
    expect(svg).not.toContain('NaN')
  }
})

test('of each who was wrong the document has the worst answer: no path at all, if there was such', () => {
  const map = generatedMap('open', { width: 20, height: 20 }, 1, 1)
  const fault = { who: 'a peer', isOurs: false, map, query: map.queries[0], least: 10 }
  const faults = [
    { ...fault, cost: 11 },
    { ...fault, cost: Number.NaN },
    { ...fault, cost: 12 },
  ]
  const other = { ...fault, who: 'another', cost: 10.5 }
  expect(byContender([...faults, other])).toMatchObject([
    { who: 'a peer', count: 3, worst: { cost: Number.NaN } },
    { who: 'another', count: 1, worst: { cost: 10.5 } },
  ])
  const checked = { queries: 4, faults: [...faults, other] }
  const { markdown } = speedDocument({ ...measured, checked }, 'speed')
  expect(markdown).toContain(
    '- a peer: 3 wrong, the worst no legal path from start to goal, on open 20×20, seed 1\n- another: 1 wrong, the worst 5.0 % too long (10.5, but the least is 10), on open 20×20, seed 1',
  )
})
