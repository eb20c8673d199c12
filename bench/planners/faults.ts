import { mkdirSync, writeFileSync } from 'node:fs'
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

/** What there is to say of those who were wrong: one line each, with the worst case. */
export function faultLines(faults: readonly Fault[]): string[] {
  const names = [...new Set(faults.map(({ who }) => who))]
  return names.map((name) => {
    const own = faults.filter(({ who }) => who === name)
    const worst = own.reduce((a, b) => (offBy(b) > offBy(a) ? b : a))
    return `${name}: ${own.length} wrong; worst ${faultInWords(worst)} on ${saveFault(worst)}`
  })
}
