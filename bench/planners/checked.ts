import { type Fault, faultsOn } from './check'
import { roadmapFaultsOn } from './check-roadmap'
import { faultLines } from './faults'
import type { BenchMap } from './maps'
import type { Peer } from './peers/peer'
import { questionsOn } from './questions'

/** What came of asking everyone, before anything is timed. */
export interface Checked {
  readonly queries: number
  readonly faults: readonly Fault[]
}

export function checkMaps(maps: readonly BenchMap[], peers: readonly Peer[]): Checked {
  return { queries: questionsOn(maps).length, faults: faultsOn(maps, peers) }
}

export function checkRoadmaps(map: BenchMap): Checked {
  return { queries: map.queries.length, faults: roadmapFaultsOn(map) }
}

export function together(all: readonly Checked[]): Checked {
  return {
    queries: all.reduce((sum, { queries }) => sum + queries, 0),
    faults: all.flatMap(({ faults }) => faults),
  }
}

/** What there is to say of a check, ours first; that peers are wrong is no failure of ours. */
export function checkInWords({ queries, faults }: Checked): string[] {
  const ours = faultLines(faults.filter(({ isOurs }) => isOurs))
  const peers = faultLines(faults.filter(({ isOurs }) => !isOurs))
  const indented = (lines: readonly string[]) => lines.map((line) => `  ${line}`)
  return [
    `Checked ${queries} queries under only-when-no-obstacles, everyone against a plain Dijkstra.`,
    ...(ours.length > 0
      ? ['WRONG, OURS:', ...indented(ours)]
      : ['Ours are right by every search.']),
    ...(peers.length > 0 ? ['Peers that give wrong lengths:', ...indented(peers)] : []),
  ]
}

export const isOursRight = ({ faults }: Checked): boolean => !faults.some(({ isOurs }) => isOurs)
