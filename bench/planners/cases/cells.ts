import type { Case } from '../case'
import { acrossAll, type BenchMap } from '../maps'
import { ask } from '../ours'
import { Flood } from '../plain/flood'

/** What a cell costs grid decomposition, against a flood of straight steps over the same cells. */
export function cellCases({ name, grid, queries }: BenchMap): Case[] {
  const query = acrossAll(grid, queries[0].start)
  const flood = new Flood(grid)
  const targets = [
    ['cells', 4],
    ['euclidean', 6],
  ] as const
  return targets.map(([cost, atMost]) => ({
    name: `a cell, cost ${cost}, ${name}`,
    against: 'plain flood',
    ours: () => ask(grid, query, 'decomposition', { cost }).expanded,
    peer: () => flood.run(query.start),
    unit: 'cell',
    target: { atMost },
  }))
}
