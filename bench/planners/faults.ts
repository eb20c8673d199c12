import { mkdirSync, writeFileSync } from 'node:fs'
import { groupBy } from '../../src/experiments/summary/groups'
import { movingAiMap } from '../../src/grid/formats/movingai'
import { cellName } from '../../src/grid/grid'
import type { Fault } from './check'

const FOLDER = 'reports/bench'

/** "11.1 % too long", or what else is wrong with it. */
export function faultInWords({ cost, least, error }: Fault): string {
  if (error !== undefined) return error
  if (Number.isNaN(cost)) return 'no legal path from start to goal'
  const percent = (100 * Math.abs(cost - least)) / least
  const way = cost > least ? 'too long' : 'too short'
  return `${percent.toPrecision(2)} % ${way} (${cost}, but the least is ${least})`
}

/** Where it can be seen: the map, the query, and the file that the map was saved to. */
function saveFault({ who, map, query }: Fault): string {
  const { grid, origin } = map
  const file = `${FOLDER}/${`${who}, ${origin}`.replaceAll(/[^a-z0-9×-]+/gi, '-')}.map`
  mkdirSync(FOLDER, { recursive: true })
  writeFileSync(file, [...movingAiMap(grid)].join(''))
  const ends = `${cellName(grid.width, query.start)} to ${cellName(grid.width, query.goal)}`
  return `${origin}, ${ends}; saved as ${file}`
}

/** How far off an answer is; what is no path at all is farthest. */
const offBy = ({ cost, least }: Fault): number =>
  Number.isFinite(cost) ? Math.abs(cost - least) / least : Number.POSITIVE_INFINITY

/** Those who were wrong, how often, and by which answer the most. */
export function byContender(faults: readonly Fault[]) {
  return [...groupBy(faults, ({ who }) => who)].map(([who, own]) => ({
    who,
    count: own.length,
    worst: own.reduce((a, b) => (offBy(b) > offBy(a) ? b : a)),
  }))
}

/** What there is to say of those who were wrong: one line each, with the worst case. */
export const faultLines = (faults: readonly Fault[]): string[] =>
  byContender(faults).map(
    ({ who, count, worst }) =>
      `${who}: ${count} wrong; worst ${faultInWords(worst)} on ${saveFault(worst)}`,
  )
