import { successByDensity } from '../experiments/summary/success'
import { type Evidence, REPORT, select } from './evidence'
import { lineChart, successAxis } from './line-chart'
import { linearScale } from './scale'
import type { Figure } from './svg'
import { percent } from './words'

/** How often each planner reaches the goal, over the density of random obstacles. */
export function densityFigure(evidence: Evidence): Figure {
  const shown = [
    ['Complete planners', select(evidence, 'decomposition')],
    ['Roadmap, 80 samples', select(evidence, 'probabilistic-roadmap', { samples: 80 })],
    ['Potential field', select(evidence, 'potential-field', REPORT.field)],
    ['… with memory', select(evidence, 'potential-field-memory', REPORT.field)],
    ['Bug2 (report)', select(evidence, 'bug2', REPORT.bug2)],
    ['Tangent Bug (report)', select(evidence, 'tangent-bug', REPORT.tangentBug)],
  ] as const
  const lines = shown.map(([name, all]) => {
    const rows = all.filter(({ family }) => family === 'random')
    const points = successByDensity(evidence.settings, rows).flatMap((series) =>
      series.points.map(({ density, success }) => ({
        x: density,
        y: success.rate,
        low: success.low,
        high: success.high,
      })),
    )
    return { name, points }
  })
  const title = 'Reachable goals that are reached, over the density of random obstacles'
  const densest = lines.map(({ name, points }) => {
    const { x, y } = points[points.length - 1]
    return `${name} ${percent(y)} at ${x} %`
  })
  const densities = lines[0].points.map(({ x }) => x)
  return {
    name: 'success-by-density',
    alt: `${title}, with 95 % intervals. ${densest.join(', ')}.`,
    svg: lineChart(
      title,
      {
        label: 'density of obstacles',
        scale: (from, to) => linearScale([0, ...densities], from, to),
        write: (density) => `${density} %`,
      },
      successAxis,
      lines,
    ),
  }
}
