import type { Row } from '../experiments/row'
import { roadmapBySamples } from '../experiments/summary/samples'
import { clockTick } from '../experiments/summary/times'
import { plural } from '../grid/plural'
import type { Chart } from './chart'
import { count, percent, quantileInWords, ratioInWords, successInWords } from './words'

/** What more samples of a probabilistic roadmap bring, and what they cost. */
export function samplesChart(rows: readonly Row[]): Chart {
  const tick = clockTick(rows)
  const curves = roadmapBySamples(rows)
  const points = curves.flatMap((curve, series) =>
    curve.points.map((point) => {
      const samples = `${count(point.samples)} ${plural(point.samples, 'sample')}`
      const words = curves.length > 1 ? `${curve.name}, ${samples}` : samples
      return { ...point, series, name: curve.name, words }
    }),
  )
  const shown = points.filter(({ success }) => success.rows.length > 0)
  return {
    id: 'samples',
    kind: 'lines',
    title: 'Probabilistic roadmap: success over samples',
    summary: [
      'How often the roadmap led to the goal where it can be reached, over the number of samples.',
      ...shown.map(
        ({ words, success, milliseconds }) =>
          `${words}: ${percent(success.rate)}, median time ${quantileInWords(milliseconds.median, tick)}.`,
      ),
    ].join(' '),
    x: { label: 'Samples', scale: 'log' },
    y: { label: 'Reached, of the goals that can be reached', scale: 'percent' },
    series: curves.map(({ name }, style) => ({ name: `Probabilistic roadmap, ${name}`, style })),
    marks: shown.map(({ series, samples, words, success, ratio, milliseconds }) => ({
      series,
      x: samples,
      y: success.rate,
      low: success.low,
      high: success.high,
      label: `${words}: ${successInWords(success)}, median ratio ${ratioInWords(ratio.quantiles.median)}, median time ${quantileInWords(milliseconds.median, tick)}`,
      runs: [{ title: 'Failed', rows: success.failures }],
    })),
    table: {
      columns: ['Settings', 'Samples', 'Reached', 'Median ratio', 'Median time'],
      rows: points.map(({ name, samples, success, ratio, milliseconds }) => [
        name,
        count(samples),
        successInWords(success),
        ratioInWords(ratio.quantiles.median),
        quantileInWords(milliseconds.median, tick),
      ]),
    },
    missing:
      new Set(shown.map(({ samples }) => samples)).size < 2
        ? 'It needs the probabilistic roadmap with at least two numbers of samples.'
        : '',
  }
}
