import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import { successByDensity } from '../experiments/summary/success'
import type { Chart } from './chart'
import { percent, successInWords } from './words'

/** Success over density, with a line for each planner setting. */
export function successChart(settings: ExperimentSettings, rows: readonly Row[]): Chart {
  const curves = successByDensity(settings, rows).map((curve) => ({
    ...curve,
    points: curve.points.filter(({ success }) => success.rows.length > 0),
  }))
  const marks = curves.flatMap(({ name, points }, series) =>
    points.map(({ density, success }) => ({
      series,
      x: density,
      y: success.rate,
      low: success.low,
      high: success.high,
      label: `${name}, density ${density} %: ${successInWords(success)}`,
      runs: [{ title: 'Failed', rows: success.failures }],
    })),
  )
  const densities = [...new Set(marks.map(({ x }) => x))].sort((a, b) => a - b)
  return {
    id: 'success',
    kind: 'lines',
    title: 'Success over density',
    summary: summaryOf(curves, densities),
    x: { label: 'Density of obstacles (%)', scale: 'linear' },
    y: { label: 'Reached, of the goals that can be reached', scale: 'percent' },
    series: curves.map(({ name, setting }) => ({ name, style: setting })),
    marks,
    table: {
      columns: ['Planner', ...densities.map((density) => `${density} %`)],
      rows: curves.map(({ name, points }) => [
        name,
        ...densities.map((density) => {
          const point = points.find((one) => one.density === density)
          return point ? percent(point.success.rate) : '–'
        }),
      ]),
    },
    missing: densities.length < 2 ? 'It needs maps of at least two densities.' : '',
  }
}

function summaryOf(curves: ReturnType<typeof successByDensity>, densities: readonly number[]) {
  const [first, last] = [densities[0], densities[densities.length - 1]]
  const ends = curves.flatMap(({ name, points }) => {
    const [from, to] = [points[0], points[points.length - 1]]
    if (!from || points.every(({ success }) => success.failures.length === 0)) return []
    return [`${name} from ${percent(from.success.rate)} to ${percent(to.success.rate)}`]
  })
  const always = curves.length - ends.length
  const sentences = [
    `How often the goal was reached where it can be reached, from ${first} % to ${last} % of obstacles, with 95 % confidence intervals.`,
    ...(always > 0 ? [`${always} of ${curves.length} planner settings always reached it.`] : []),
    ...(ends.length > 0 ? [`${ends.join('; ')}.`] : []),
  ]
  return sentences.join(' ')
}
