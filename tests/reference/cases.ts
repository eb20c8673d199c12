import { mapNumber } from './maps'
import { shrink } from './shrink'
import { RULES, textOf, type World } from './world'

/**
 * How many maps, of which list, and from which number on: `MAPS=1 FIRST=1234` tries again only the
 * map that failed.
 */
const COUNT = Number(process.env.MAPS ?? 2000)
const SEED = Number(process.env.SEED ?? 1)
const FIRST = Number(process.env.FIRST ?? 0)

/** Whether there are so many maps that what is rare is among them, too. */
export const ARE_MANY = COUNT >= 1000

/** So long may one test take: all maps of a long run by hand. */
export const LONG = 6 * 60 * 60 * 1000

/** What must hold on a map; throws if it does not. `index` chooses among settings. */
type Property = (world: World, index: number) => void

/**
 * Tries a property on every map under both diagonal rules. A failure names the map by its number
 * and shows the smallest map cut from it on which the property still fails.
 */
export async function onEveryMap(property: Property): Promise<void> {
  for (let index = FIRST; index < FIRST + COUNT; index++) {
    for (const rule of RULES) tryOn(mapNumber(SEED, index, rule), index, property)
    // Lets the test runner speak with this worker in between.
    if (index % 50 === 0) await new Promise((resolve) => setImmediate(resolve))
  }
}

function tryOn(world: World, index: number, property: Property): void {
  const fault = faultOn(world, index, property)
  if (!fault) return
  const smaller = shrink(world, (candidate) => faultOn(candidate, index, property) !== undefined)
  const shown = faultOn(smaller, index, property) ?? fault
  throw new Error(
    `Map ${index} of seed ${SEED}: ${shown.message}\n${textOf(smaller)}\ncut from (${fault.message})\n${textOf(world)}`,
    { cause: shown },
  )
}

function faultOn(world: World, index: number, property: Property): Error | undefined {
  try {
    property(world, index)
    return undefined
  } catch (fault) {
    return fault instanceof Error ? fault : new Error(String(fault))
  }
}

/** Throws what is wrong; cheaper than `expect` where there are millions of checks. */
export function must(holds: boolean, otherwise: () => string): asserts holds {
  if (!holds) throw new Error(otherwise())
}

/** Equal but for rounding: 1e-9 of the value. */
export function isClose(a: number, b: number): boolean {
  return a === b || Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(a), Math.abs(b))
}
