import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import {
  clockTick,
  estimateBelowTick,
  type TimePoint,
  timeBySize,
} from '../experiments/summary/times'
import type { Size } from '../grid/grid'
import { plural } from '../grid/plural'
import type { Chart } from './chart'
import { count, millisecondsInWords, quantileInWords } from './words'

const SLOWEST = 50

/** The median, or an estimate, which is no less than if the clock had ticked in one of the runs. */
const timeOf = ({ milliseconds: { median }, rows }: TimePoint, tick: number): number =>
  median < tick ? Math.max(estimateBelowTick(rows, tick), tick / rows.length) : median

/** Time to plan over the size of the map, with a line for each planner setting. */
export function timeChart(settings: ExperimentSettings, rows: readonly Row[]): Chart {
  const tick = clockTick(rows)
  const curves = timeBySize(settings, rows)
  const hasEstimates = curves.some(({ points }) =>
    points.some(({ milliseconds }) => milliseconds.median < tick),
  )
  const marks = curves.flatMap(({ name, points }, series) =>
    points.map((point) => ({
      series,
      x: point.cells,
      y: timeOf(point, tick),
      low: point.milliseconds.lower < tick ? 0 : point.milliseconds.lower,
      high: Math.max(point.milliseconds.upper, tick),
      label: `${name}, ${sizeOf(point)}: ${spreadInWords(point, tick)}, ${count(point.rows.length)} ${plural(point.rows.length, 'run')}`,
      runs: [{ title: 'Slowest', rows: slowest(point.rows) }],
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
      ...(hasEstimates
        ? [`Medians under ${millisecondsInWords(tick)}, a tick of the clock, are estimated.`]
        : []),
      ...curves.map(({ name, points }) => {
        const [from, to] = [points[0], points[points.length - 1]]
        return `${name}: ${medianInWords(from, tick)} to ${medianInWords(to, tick)}.`
      }),
    ].join(' '),
    x: { label: 'Cells of the map', scale: 'log' },
    y: {
      label: `Median time to plan (ms)${hasEstimates ? `; below ${tick} estimated` : ''}`,
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
          return point ? medianInWords(point, tick) : '–'
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

/** "12 µs", "about 24 µs" of an estimate, or "under 100 µs" if there is nothing to estimate it by. */
function medianInWords({ milliseconds: { median }, rows }: TimePoint, tick: number): string {
  const estimate = median < tick ? estimateBelowTick(rows, tick) : 0
  return estimate > 0 ? `about ${millisecondsInWords(estimate)}` : quantileInWords(median, tick)
}

function spreadInWords(point: TimePoint, tick: number): string {
  const { median, lower, upper } = point.milliseconds
  const [words, from, to] = [median, lower, upper].map((time) => quantileInWords(time, tick))
  if (median >= tick) return `median ${words}, half from ${from} to ${to}`
  const estimate = medianInWords(point, tick)
  return estimate === words ? `median ${words}` : `median ${words}, ${estimate}`
}
