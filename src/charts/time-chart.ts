import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import type { Quantiles } from '../experiments/summary/statistics'
import { clockTick, timeBySize } from '../experiments/summary/times'
import type { Size } from '../grid/grid'
import { plural } from '../grid/plural'
import type { Chart } from './chart'
import { count, millisecondsInWords, quantileInWords } from './words'

const SLOWEST = 50

/**
 * The median; or where it is less than a tick of the clock, the mean, which many runs tell more exactly:
 * to a tick of all of them together. A few slow runs do not lift it over the tick.
 */
const timeOf = ({ median, mean }: Quantiles, runs: number, tick: number): number =>
  median < tick ? Math.min(Math.max(mean, tick / runs), tick) : median

/** Time to plan over the size of the map, with a line for each planner setting. */
export function timeChart(settings: ExperimentSettings, rows: readonly Row[]): Chart {
  const tick = clockTick(rows)
  const curves = timeBySize(settings, rows)
  const hasMeans = curves.some(({ points }) =>
    points.some(({ milliseconds }) => milliseconds.median < tick),
  )
  const marks = curves.flatMap(({ name, points }, series) =>
    points.map(({ cells, rows: own, milliseconds, ...size }) => ({
      series,
      x: cells,
      y: timeOf(milliseconds, own.length, tick),
      low: milliseconds.lower < tick ? 0 : milliseconds.lower,
      high: Math.max(milliseconds.upper, tick),
      label: `${name}, ${sizeOf(size)}: ${spreadInWords(milliseconds, tick)}, ${count(own.length)} ${plural(own.length, 'run')}`,
      runs: [{ title: 'Slowest', rows: slowest(own) }],
    })),
  )
  const sizes = [
    ...new Map(
      curves.flatMap(({ points }) => points.map((one) => [sizeOf(one), one.cells] as const)),
    ),
  ].sort(([, a], [, b]) => a - b)
  return {
    id: 'time',
    kind: 'lines',
    title: 'Time to plan over size',
    summary: [
      'Median time to plan over the number of cells of the map, both logarithmic; half of the runs lie within the bars.',
      ...curves.map(({ name, points }) => {
        const [from, to] = [points[0], points[points.length - 1]]
        const [first, last] = [from, to].map(({ milliseconds }) =>
          quantileInWords(milliseconds.median, tick),
        )
        return `${name}: ${first} to ${last}.`
      }),
    ].join(' '),
    x: { label: 'Cells of the map', scale: 'log' },
    y: {
      label: `Median time to plan (ms)${hasMeans ? `; below ${tick} the mean` : ''}`,
      scale: 'log',
    },
    series: curves.map(({ name, setting }) => ({ name, style: setting })),
    marks,
    table: {
      columns: ['Planner', ...sizes.map(([size]) => size)],
      rows: curves.map(({ name, points }) => [
        name,
        ...sizes.map(([size]) => {
          const point = points.find((one) => sizeOf(one) === size)
          return point ? medianInWords(point.milliseconds, tick) : '–'
        }),
      ]),
    },
    missing: missingOf(sizes.length, tick),
  }
}

const sizeOf = ({ width, height }: Size): string => `${width} × ${height}`

const slowest = (rows: readonly Row[]): Row[] =>
  [...rows].sort((a, b) => b.milliseconds - a.milliseconds).slice(0, SLOWEST)

function missingOf(sizes: number, tick: number): string {
  if (sizes < 2) return 'It needs maps of at least two sizes.'
  return tick > 0 ? '' : 'All runs were too short for the clock.'
}

/** "12 µs"; "under 100 µs, mean 24 µs". */
function medianInWords({ median, mean }: Quantiles, tick: number): string {
  const words = quantileInWords(median, tick)
  return median < tick && mean > 0 ? `${words}, mean ${millisecondsInWords(mean)}` : words
}

function spreadInWords(milliseconds: Quantiles, tick: number): string {
  const { median, lower, upper } = milliseconds
  const words = `median ${medianInWords(milliseconds, tick)}`
  if (median < tick) return words
  return `${words}, half from ${quantileInWords(lower, tick)} to ${quantileInWords(upper, tick)}`
}
