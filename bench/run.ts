import type { Case } from './case'
import { checkInWords, checkMap, checkRoadmaps, isOursRight, together } from './checked'
import type { Command } from './command'
import { generatedMap, MAP_KINDS } from './maps'
import { furtherMaps, parts } from './parts'
import { allPeers } from './peers/all'
import { type Figures, figuresOf, timeInTurn } from './timing'
import { COLUMNS, columnsOf, lineOf, plainName } from './words'

/** What one case came to. */
export interface Result {
  readonly one: Case
  readonly figures: Figures
}

/** Checks first, then times the generated maps; returns whether all is right and fast enough. */
export function benchGenerated({ quick, only }: Command): boolean {
  const isChosen = ({ name }: Case) => plainName(name).includes(plainName(only))
  const chosen = parts.filter(
    (part) => !(quick && part.isLarge) && part.cases(part.make()).some(isChosen),
  )
  const checked = together([
    ...[...furtherMaps()].map((map) => checkMap(map, allPeers)),
    ...MAP_KINDS.map((kind) => checkRoadmaps(generatedMap(kind, { width: 120, height: 80 }, 1, 2))),
    ...chosen.map((part) => checkMap(part.make(), part.peers)),
  ])
  say(checkInWords(checked).join('\n'))
  if (!isOursRight(checked)) return false
  return timeAll(chosen.flatMap((part) => [() => part.cases(part.make()).filter(isChosen)]))
}

/** Times the cases map by map; returns whether all targets are met. */
export function timeAll(cases: readonly (() => readonly Case[])[]): boolean {
  say(`\n${lineOf(COLUMNS)}`)
  const results = cases.flatMap((make) => make().map(timed))
  const missed = results.filter(({ figures }) => !figures.met)
  const bound = results.filter(({ one }) => one.target !== null)
  say(`\n${bound.length - missed.length} of ${bound.length} targets met.`)
  for (const { one } of missed) say(`  missed: ${one.name} against ${one.against}`)
  return missed.length === 0
}

function timed(one: Case): Result {
  const figures = figuresOf(one.target, timeInTurn(one.ours, one.peer))
  say(lineOf(columnsOf(one, figures)))
  return { one, figures }
}

function say(line: string): void {
  process.stdout.write(`${line}\n`)
}
