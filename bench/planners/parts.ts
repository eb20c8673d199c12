import type { Case } from './case'
import { cellCases } from './cases/cells'
import { fieldCase } from './cases/fields'
import { roadmapCases, visibilityCase } from './cases/roadmaps'
import { ceilingCase, firstQueryCases, type SearchTargets, searchCases } from './cases/searches'
import { tapeCases, tapelessCases } from './cases/tapes'
import { type BenchMap, generatedMap, MAP_KINDS, type MapKind, WIDE_KINDS } from './maps'
import { allPeers, sturdyPeers, swiftPeers } from './peers/all'
import type { Peer } from './peers/peer'
import { turnAbout } from './turned'

/** A map of the bench, or several that are asked about in turn, and what is done with them. */
export interface Part {
  readonly isLarge: boolean
  /** Made anew each time, so that nobody has to keep the maps of all parts. */
  readonly make: () => readonly BenchMap[]
  readonly peers: readonly Peer[]
  readonly cases: (maps: readonly BenchMap[]) => Case[]
}

const SIZES = [
  { width: 60, height: 40, queries: 8, kinds: MAP_KINDS, isLarge: false },
  { width: 200, height: 200, queries: 4, kinds: MAP_KINDS, isLarge: false },
  { width: 1000, height: 1000, queries: 2, kinds: [...MAP_KINDS, ...WIDE_KINDS], isLarge: true },
] as const

const SEED = 1

type BenchSize = (typeof SIZES)[number]

/** All maps that are timed. */
export const parts: readonly Part[] = [
  ...SIZES.flatMap((size) => size.kinds.map((kind) => mapPart(kind, size))),
  ...SIZES.flatMap((size) => MAP_KINDS.map((kind) => firstQueryPart(kind, size))),
]

function mapPart(kind: MapKind, size: BenchSize): Part {
  const { isLarge, queries } = size
  return {
    isLarge,
    peers: isLarge ? sturdyPeers : allPeers,
    make: () => [generatedMap(kind, size, SEED, queries)],
    cases: ([map]) => casesOn(kind, map, isLarge),
  }
}

function firstQueryPart(kind: MapKind, size: BenchSize): Part {
  const { isLarge, queries } = size
  return {
    isLarge,
    peers: isLarge ? swiftPeers : allPeers,
    make: () => turnAbout(generatedMap(kind, size, SEED, queries)),
    cases: firstQueryCases,
  }
}

function casesOn(kind: MapKind, map: BenchMap, isLarge: boolean): Case[] {
  const cases = [
    ...searchCases(map, targetsOn(kind, isLarge)),
    ...cellCases(map),
    visibilityCase(map),
  ]
  if (map.grid.width === 60) cases.push(ceilingCase(map))
  // Before any tape is written: code that has seen one may be compiled to another.
  if (map.grid.width === 200 && kind === 'random') cases.push(...tapelessCases(map))
  if (map.grid.width === 200 || (isLarge && kind === 'random')) cases.push(...tapeCases(map))
  if (isLarge) cases.push(...roadmapCases(map), fieldCase(map))
  return cases
}

function targetsOn(kind: MapKind, isLarge: boolean): SearchTargets {
  const others = { dijkstra: isLarge ? 40 : 12, 'a-star': 15 }
  if (kind === 'open') return others
  return { ...others, 'jump-point': kind === 'random' ? 15 : 100 }
}

/** Small maps that are only checked, to find out who gives wrong lengths. */
export function* furtherMaps(): Generator<BenchMap> {
  for (let seed = 2; seed <= 21; seed++) {
    for (const kind of MAP_KINDS) yield generatedMap(kind, { width: 60, height: 40 }, seed, 4)
  }
}
