import { millisecondsInWords } from '../../charts/words'
import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import { GIVEN_MAPS, mapKinds } from '../../experiments/settings'
import { generators } from '../../grid/generators'
import type { Status } from '../../trace/events'
import { cellsInWords } from '../words/numbers'

const STATUS: Readonly<Record<Status, string>> = {
  reached: 'reached',
  unreachable: 'proven unreachable',
  'not-found': 'no path found',
  'local-minimum': 'local minimum',
  'dead-end': 'dead end',
  loop: 'loop',
}

/** Which map it is: "Map 12: Random obstacles, density 30, 40 × 40". */
export function mapInWords(settings: ExperimentSettings, row: Row): string {
  const size = `${row.width} × ${row.height}`
  if (row.family === GIVEN_MAPS) {
    const kinds = mapKinds(settings)
    return `Map ${row.map}: ${kinds[row.map % kinds.length].given?.name ?? 'opened map'}, ${size}`
  }
  const title = generators.find(({ id }) => id === row.family)?.title ?? row.family
  const params = Object.entries(row.mapParams).map(([name, value]) => `${name} ${value}`)
  return `Map ${row.map}: ${[title, ...params, size].join(', ')}`
}

/** How the run ended: "loop after 120 cells, time 2.1 ms". */
export const runInWords = (row: Row): string =>
  `${endInWords(row)}, time ${millisecondsInWords(row.milliseconds)}`

/** "loop after 120 cells", "reached in 52 cells, 1.040 times the optimum". */
function endInWords({ status, cells, ratio }: Row): string {
  const words = STATUS[status]
  if (ratio !== null) {
    return `${words} in ${cellsInWords(cells)}, ${ratio.toFixed(3)} times the optimum`
  }
  return cells > 0 ? `${words} after ${cellsInWords(cells)}` : words
}
