import { readFileSync } from 'node:fs'
import { basename } from 'node:path'
import { InputError, messageOf } from '../../src/grid/errors'
import { fileText } from '../../src/grid/file-text'
import { readMovingAiMap } from '../../src/grid/formats/movingai'
import { readScenarios, type Scenario } from '../../src/grid/formats/movingai-scenarios'
import { isObstacle, placeName } from '../../src/grid/grid'
import type { BenchMap } from './maps'
import { ask, searchesOf } from './ours'

/** A map of the MovingAI benchmarks with its scenarios, one query each. */
export interface ScenarioMap {
  readonly map: BenchMap
  readonly scenarios: readonly Scenario[]
}

/**
 * The maps and what the scenario files ask on them; which map a scenario is for is told by its name.
 * @throws InputError that names the file.
 */
export function readScenarioMaps(
  maps: readonly string[],
  scenarios: readonly string[],
): ScenarioMap[] {
  const asked = scenarios.flatMap((file) => inFile(file, readScenarios))
  const read = maps.map((file) => {
    const grid = inFile(file, readMovingAiMap)
    const own = asked.filter(({ map }) => basename(map) === basename(file))
    const name = basename(file)
    if (own.length === 0) throw new InputError(`No scenario file asks anything on ${name}.`)
    const odd = own.find(({ width, height }) => width !== grid.width || height !== grid.height)
    if (odd) {
      const sizes = `${grid.width} × ${grid.height}, not ${odd.width} × ${odd.height}`
      throw new InputError(`${name} is ${sizes}, as its scenarios say.`)
    }
    const ends = own.flatMap(({ start, goal }) => [start, goal])
    const blocked = ends.find(({ x, y }) => isObstacle(grid, x, y))
    if (blocked) {
      const place = placeName(blocked)
      throw new InputError(`${name} has an obstacle at ${place}, where a scenario begins or ends.`)
    }
    const queries = own.map(({ start, goal }) => ({
      start: start.y * grid.width + start.x,
      goal: goal.y * grid.width + goal.x,
    }))
    return { map: { name, origin: name, grid, queries }, scenarios: own }
  })
  const names = new Set(maps.map((file) => basename(file)))
  const missing = asked.find(({ map }) => !names.has(basename(map)))
  if (missing) throw new InputError(`The scenarios ask for ${missing.map}: name that file, too.`)
  return read
}

function inFile<T>(file: string, read: (text: string) => T): T {
  try {
    return read(fileText(readFileSync(file, 'utf8')))
  } catch (error) {
    throw new InputError(`${file}: ${messageOf(error)}`)
  }
}

/** Files print at least so many digits; of "4" those behind the point are left out. */
const LEAST_DIGITS = 6

/** Whether a length is the stated one, as far as the digits go that are printed of it. */
export function isAsStated(length: number, stated: number): boolean {
  const printed = String(stated).replace('.', '').length
  const place = Math.floor(Math.log10(stated || 1)) + 1 - Math.max(LEAST_DIGITS, printed)
  return Math.abs(length - stated) <= 0.500001 * 10 ** place
}

/** Each scenario whose length is not the stated one, by any search, in words. */
export function misstated({ map, scenarios }: ScenarioMap): string[] {
  return scenarios.flatMap(({ length, start, goal }, i) =>
    searchesOf('decomposition').flatMap((search) => {
      const params = { cost: 'euclidean', search }
      const { status, cost } = ask(map.grid, map.queries[i], 'decomposition', params)
      if (status === 'reached' && isAsStated(cost, length)) return []
      const ends = `(${start.x}, ${start.y}) to (${goal.x}, ${goal.y})`
      return [`${map.name} ${ends}: decomposition ${search} ${status}, ${cost}; stated ${length}`]
    }),
  )
}
