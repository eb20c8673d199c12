import { Tape } from 'path-planner'
import type { Case, Work } from '../case'
import type { BenchMap } from '../maps'
import { ask, askTapeless, searchesOf } from '../ours'
import { allQueries } from '../questions'

/** Grid decomposition that writes a tape, a new one each time, against the same without one. */
export function tapeCases(map: BenchMap): Case[] {
  return searchesOf('decomposition').map((search) => ({
    name: `tape of decomposition ${search}, ${map.name}`,
    against: 'no tape',
    ours: decompositions(map, search, ask, () => new Tape()),
    peer: decompositions(map, search, ask),
    unit: 'query',
    target: { atMost: 1.5 },
  }))
}

/**
 * The same without a tape against the library built without tapes: what it costs that one may be
 * given. Two builds of the same source differ by up to 3 percent, hence the target.
 */
export function tapelessCases(map: BenchMap): Case[] {
  return searchesOf('decomposition').map((search) => ({
    name: `no tape, decomposition ${search}, ${map.name}`,
    against: 'built without tapes',
    ours: decompositions(map, search, ask),
    peer: decompositions(map, search, askTapeless),
    unit: 'query',
    target: { atMost: 1.1 },
    isClose: true,
  }))
}

function decompositions(
  map: BenchMap,
  search: string,
  asked: typeof ask,
  newTape?: () => Tape,
): Work {
  const params = { cost: 'euclidean', search }
  return allQueries([map], (grid, query) =>
    asked(grid, query, 'decomposition', params, newTape?.()),
  )
}
