import { searchCases } from './cases/searches'
import { checkInWords, checkMaps, isOursRight, together } from './checked'
import type { Command } from './command'
import type { BenchMap } from './maps'
import { misstated, readScenarioMaps } from './movingai'
import { allPeers, sturdyPeers } from './peers/all'
import { timeAll } from './timed'
import { say } from './words'

/** Peers take long on large maps: they are asked so many of a file's scenarios, spread evenly. */
const MOST_QUERIES = 20
const SMALL = 200 * 200

/** Checks maps and scenarios from files, then times them; returns whether all is right and fast. */
export function benchFiles({ maps, scenarios }: Command): boolean {
  const read = readScenarioMaps(maps, scenarios)
  const wrong = read.flatMap(misstated)
  const asked = read.reduce((sum, { scenarios }) => sum + scenarios.length, 0)
  say(`${asked} scenarios; lengths other than stated: ${wrong.length}`)
  for (const line of wrong) say(`  ${line}`)
  const some = read.map(({ map }) => withFewer(map))
  const checked = together(
    some.map((map) => checkMaps([map], map.grid.walls.length > SMALL ? sturdyPeers : allPeers)),
  )
  say(checkInWords(checked).join('\n'))
  if (wrong.length > 0 || !isOursRight(checked)) return false
  timeAll(some.flatMap((map) => searchCases(map, {})))
  return true
}

function withFewer(map: BenchMap): BenchMap {
  const every = Math.ceil(map.queries.length / MOST_QUERIES)
  return { ...map, queries: map.queries.filter((_, i) => i % every === every - 1) }
}
