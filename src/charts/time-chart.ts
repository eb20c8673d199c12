import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import type { Quantiles } from '../experiments/summary/statistics'
import { timeBySize } from '../experiments/summary/times'
import type { Size } from '../grid/grid'
import { plural } from '../grid/plural'
import type { Chart } from './chart'
import { count, millisecondsInWords } from './words'

const SLOWEST = 50

/** In milliseconds, less than any clock can tell: 0 has no logarithm. */
const LEAST_TIME = 0.001

/** The median; or the mean if the median is 0, because most runs are shorter than a tick of the clock. */
const timeOf = ({ median, mean }: Quantiles): number =>
  Math.max(median > 0 ? median : mean, LEAST_TIME)

/** Time to plan over the size of the map, with a line for each planner setting. */
export function timeChart(settings: ExperimentSettings, rows: readonly Row[]): Chart {
  const curves = timeBySize(settings, rows)
  const marks = curves.flatMap(({ name, points }, series) =>
    points.map(({ cells, rows: own, milliseconds, ...size }) => ({
      series,
      x: cells,
      y: timeOf(milliseconds),
      low: Math.max(milliseconds.lower, LEAST_TIME),
      high: Math.max(milliseconds.upper, LEAST_TIME),
      label: `${name}, ${sizeOf(size)}: ${timeInWords(milliseconds)}, ${count(own.length)} ${plural(own.length, 'run')}`,
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
        return `${name}: ${millisecondsInWords(timeOf(from.milliseconds))} to ${millisecondsInWords(timeOf(to.milliseconds))}.`
      }),
    ].join(' '),
    x: { label: 'Cells of the map', scale: 'log' },
    y: { label: 'Time to plan (ms)', scale: 'log' },
    series: curves.map(({ name, setting }) => ({ name, style: setting })),
    marks,
    table: {
      columns: ['Planner', ...sizes.map(([size]) => size)],
      rows: curves.map(({ name, points }) => [
        name,
        ...sizes.map(([size]) => {
          const point = points.find((one) => sizeOf(one) === size)
          return point ? millisecondsInWords(timeOf(point.milliseconds)) : '–'
        }),
      ]),
    },
    missing: sizes.length < 2 ? 'It needs maps of at least two sizes.' : '',
  }
}

const sizeOf = ({ width, height }: Size): string => `${width} × ${height}`

const slowest = (rows: readonly Row[]): Row[] =>
  [...rows].sort((a, b) => b.milliseconds - a.milliseconds).slice(0, SLOWEST)

function timeInWords(milliseconds: Quantiles): string {
  const { median, mean, lower, upper } = milliseconds
  if (median === 0) return `mean ${millisecondsInWords(mean)}`
  return `median ${millisecondsInWords(median)}, half from ${millisecondsInWords(lower)} to ${millisecondsInWords(upper)}`
}
