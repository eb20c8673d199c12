import { Tape } from 'path-planner'
import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask, searchesOf } from '../ours'

/** Grid decomposition that writes a tape, a new one each time, against the same without one. */
export function tapeCases({ name, grid, queries }: BenchMap): Case[] {
  return searchesOf('decomposition').map((search) => {
    const params = { cost: 'euclidean', search }
    const work = (withTape: boolean) => () => {
      for (const query of queries) {
        ask(grid, query, 'decomposition', params, withTape ? new Tape() : undefined)
      }
      return queries.length
    }
    return {
      name: `tape of decomposition ${search}, ${name}`,
      against: 'no tape',
      ours: work(true),
      peer: work(false),
      unit: 'query',
      target: { atMost: 1.5 },
    }
  })
}
