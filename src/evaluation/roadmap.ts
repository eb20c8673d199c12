import type { Row } from '../experiments/row'
import { groupByNumber } from '../experiments/summary/groups'
import { roadmapBySamples, type SamplesPoint } from '../experiments/summary/samples'
import { successOf } from '../experiments/summary/success'
import { type Evidence, type Section, select } from './evidence'
import { lineChart, successAxis } from './line-chart'
import { logScale } from './scale'
import type { Figure } from './svg'
import { count, figure, milliseconds, percent, table, withInterval } from './words'

export function roadmapSection(evidence: Evidence): Section {
  const rows = select(evidence, 'probabilistic-roadmap')
  const [{ points }] = roadmapBySamples(rows)
  const [few, many] = [points[0], points[points.length - 1]]
  const isRising = (numberOf: (point: SamplesPoint) => number) =>
    points.every((point, i) => i === 0 || numberOf(point) > numberOf(points[i - 1]))
  const finds = isRising(({ success }) => success.rate) && isRising(optimalShare)
  const slows = isRising((point) => point.milliseconds.median)
  const asReported = rows.filter(({ params, width }) => params.samples === width)
  const bySide = groupByNumber(asReported, ({ width }) => width).map(
    ([side, own]) => `${side} × ${side} ${percent(successOf(own).rate)}`,
  )
  return {
    title: 'Roadmaps: more samples find more, and take longer',
    claim:
      'There is a tradeoff between the time needed to compute and the number of random samples in the map: increasing the number of nodes increases the chance to find a shortest path, but requires more computational time to create the edges.',
    body: [
      `${finds ? 'Borne out' : 'Borne out in the large, though not from each number of samples to the next'}${finds && !slows ? ', though the time does not rise from each number of samples to the next' : ''}. From ${few.samples} to ${many.samples} samples the share of reachable goals that are reached goes from ${percent(few.success.rate)} to ${percent(many.success.rate)}, the share reached by a shortest path, with the least number of cells, from ${percent(optimalShare(few))} to ${percent(optimalShare(many))}, and the median time to plan from ${milliseconds(few.milliseconds.median)} to ${milliseconds(many.milliseconds.median)}.`,
      table(
        ['Samples', 'reached (95 % interval)', 'by a shortest path', 'mean ratio', 'time, median'],
        points.map((point) => [
          count(point.samples),
          withInterval(point.success),
          percent(optimalShare(point)),
          figure(point.ratio.quantiles.mean),
          milliseconds(point.milliseconds.median),
        ]),
      ),
      `Shares are of all goals that can be reached; the ratio is that of the paths that were found, and few samples find the easy ones only. With as many samples as the map has columns, the report's choice, it reaches: ${bySide.join(', ')}.`,
    ].join('\n\n'),
    figures: [samplesFigure(rows)],
  }
}

/** How many of the reachable goals are reached with the least number of cells. */
const optimalShare = ({ ratio, success }: SamplesPoint): number =>
  ratio.optimal.length / success.rows.length

function samplesFigure(rows: readonly Row[]): Figure {
  const lines = groupByNumber(rows, ({ width }) => width).map(([side, own]) => ({
    name: `${side} × ${side} cells`,
    points: roadmapBySamples(own)[0].points.map(({ samples, success }) => ({
      x: samples,
      y: success.rate,
      low: success.low,
      high: success.high,
    })),
  }))
  const samples = [...new Set(lines.flatMap(({ points }) => points.map(({ x }) => x)))]
  const title = 'Probabilistic roadmaps: success over samples, with 95 % intervals'
  const most = lines.map(({ name, points }) => `${name} ${percent(points[points.length - 1].y)}`)
  return {
    name: 'roadmap-samples',
    alt: `${title}. With ${samples[samples.length - 1]} samples: ${most.join(', ')}.`,
    svg: lineChart(
      title,
      {
        label: 'samples',
        scale: (from, to) => ({ ...logScale(samples, from, to), ticks: samples }),
        write: count,
      },
      successAxis,
      lines,
    ),
  }
}
