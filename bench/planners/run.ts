import { mkdirSync, writeFileSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { InputError } from '../../src/grid/errors'
import type { Case } from './case'
import {
  type Checked,
  checkInWords,
  checkMaps,
  checkRoadmaps,
  isOursRight,
  together,
} from './checked'
import type { Command } from './command'
import { type SpeedDocument, speedDocument } from './document'
import { type Growth, growers, isGrowthMet, measureGrowth } from './growth'
import { generatedMap, MAP_KINDS } from './maps'
import { furtherMaps, type Part, parts } from './parts'
import { allPeers } from './peers/all'
import { targetsMet, timeAll } from './timed'
import { growthInWords, plainName, say } from './words'

/**
 * Checks first, then times the generated maps; returns whether all is right and fast enough.
 * @throws InputError if no case is named so
 */
export function benchGenerated({ quick, only, docs }: Command): boolean {
  const isChosen = ({ name }: Case) => plainName(name).includes(plainName(only))
  const chosen = parts.filter(
    (part) => !(quick && part.isLarge) && part.cases(part.make()).some(isChosen),
  )
  if (chosen.length === 0) throw new InputError(`No case has "${only}" in its name.`)
  const checked = checkAll(chosen)
  say(checkInWords(checked).join('\n'))
  if (!isOursRight(checked)) return false
  const results = timeAll(casesOf(chosen, isChosen))
  const growth = quick || only !== '' ? [] : growthOf(docs)
  if (docs) write(speedDocument({ checked, results, growth, machine: machine() }, 'speed'))
  return targetsMet(results) && growth.every(isGrowthMet)
}

/** Map by map, so that one can be forgotten before the next is made. */
function* casesOf(chosen: readonly Part[], isChosen: (one: Case) => boolean): Generator<Case> {
  for (const part of chosen) yield* part.cases(part.make()).filter(isChosen)
}

function checkAll(chosen: readonly Part[]): Checked {
  const roadmapSize = { width: 120, height: 80 }
  return together([
    ...[...furtherMaps()].map((map) => checkMaps([map], allPeers)),
    ...MAP_KINDS.map((kind) => checkRoadmaps(generatedMap(kind, roadmapSize, 1, 2))),
    ...chosen.map((part) => checkMaps(part.make(), part.peers)),
  ])
}

/** All planners for the document; without it, those whose growth has a target. */
function growthOf(docs: boolean): Growth[] {
  say('')
  const growth = measureGrowth(growers.filter(({ isLinear }) => docs || isLinear))
  for (const one of growth) say(growthInWords(one))
  return growth
}

function machine(): string {
  const { node, v8 } = process.versions
  return `Node ${node} (V8 ${v8}), ${availableParallelism()} cores`
}

function write({ markdown, figures }: SpeedDocument): void {
  mkdirSync('docs/speed', { recursive: true })
  for (const { name, svg } of figures) writeFileSync(`docs/speed/${name}.svg`, svg)
  writeFileSync('docs/speed.md', markdown)
}
