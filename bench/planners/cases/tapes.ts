import { Tape } from 'path-planner'
import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask, askTapeless, searchesOf } from '../ours'

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

/**
 * The same without a tape against the library built without tapes: what it costs that one may be
 * given. Two builds of the same source differ by up to 3 percent, hence the target.
 */
export function tapelessCases({ name, grid, queries }: BenchMap): Case[] {
  return searchesOf('decomposition').map((search) => {
    const params = { cost: 'euclidean', search }
    const work = (asked: typeof ask) => () => {
      for (const query of queries) asked(grid, query, 'decomposition', params)
      return queries.length
    }
    return {
      name: `no tape, decomposition ${search}, ${name}`,
      against: 'built without tapes',
      ours: work(ask),
      peer: work(askTapeless),
      unit: 'query',
      target: { atMost: 1.1 },
      isClose: true,
    }
  })
}
