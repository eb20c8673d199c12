import { describe, expect, test } from 'vitest'
import { runFrom, straightRuns } from '../../src/algorithms/grid-search/jump-points/straight-runs'
import { successorsUnder } from '../../src/algorithms/grid-search/successors'
import { stepOffsets } from '../../src/grid/directions'
import type { Grid } from '../../src/grid/grid'
import { allLegalSteps } from '../../src/grid/legal-steps'
import { randomNumbers } from '../../src/grid/random'
import { DIAGONAL_RULES } from '../../src/grid/steps'
import { plan } from '../../src/index'

function randomGrid(seed: number): Grid {
  const random = randomNumbers(seed)
  // Lines of one word, of a full one, and of several.
  const width = 2 + Math.floor(random() * 80)
  const height = 2 + Math.floor(random() * 80)
  const density = random() * 0.5
  const walls = Uint8Array.from({ length: width * height }, () => (random() < density ? 1 : 0))
  return { width, height, walls }
}

describe.each(DIAGONAL_RULES)('straight runs under %s', (rule) => {
  test('lead as far as walking step by step does', () => {
    const wrong: string[] = []
    let compared = 0
    for (let seed = 1; seed <= 40; seed++) {
      const grid = randomGrid(seed)
      const { width, walls } = grid
      const legal = allLegalSteps(grid, rule)
      const runs = straightRuns(grid, rule)
      const offsets = stepOffsets(width)
      for (let cell = 0; cell < walls.length; cell++) {
        for (const d of [0, 2, 4, 6]) {
          if (((legal[cell] >> d) & 1) === 0) continue
          let ways = 1 << d
          let steps = 0
          for (let at = cell; ways === 1 << d; steps++) {
            at += offsets[d]
            ways = successorsUnder(rule)[(d << 8) | legal[at]]
          }
          const [x, y] = [cell % width, Math.floor(cell / width)]
          const run = runFrom(runs[d], x, y, d)
          if (run !== (ways === 0 ? -steps : steps)) wrong.push(`seed ${seed}: ${x}, ${y}, ${d}`)
          compared++
        }
      }
    }
    expect(wrong).toEqual([])
    expect(compared).toBeGreaterThan(100_000)
  })
})

test('jump points lead to the least cost on maps wider than a word', () => {
  const random = randomNumbers(5)
  let reached = 0
  for (let seed = 1; seed <= 150; seed++) {
    const grid = randomGrid(seed)
    const free = Array.from(grid.walls.keys()).filter((cell) => grid.walls[cell] === 0)
    const anyFree = () => free[Math.floor(random() * free.length)]
    for (const diagonal of DIAGONAL_RULES) {
      for (const cost of ['cells', 'euclidean']) {
        const problem = { grid, start: anyFree(), goal: anyFree(), diagonal }
        const ask = (search: string) => plan(problem, 'decomposition', { params: { cost, search } })
        const expected = ask('dijkstra')
        const { status, cost: found } = ask('jump-point')
        expect(status).toBe(expected.status)
        expect(found).toBeCloseTo(expected.cost, 9)
        if (status === 'reached') reached++
      }
    }
  }
  expect(reached).toBeGreaterThan(300)
})
