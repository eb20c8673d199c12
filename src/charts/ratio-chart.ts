import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import { ratioBySetting } from '../experiments/summary/ratios'
import type { Chart } from './chart'
import { count, ratioInWords } from './words'

const LONGEST = 50

/** How long paths are compared with the optimum: where most lie, for each planner setting. */
export function ratioChart(settings: ExperimentSettings, rows: readonly Row[]): Chart {
  const distributions = ratioBySetting(settings, rows)
    .map(({ points: [distribution], ...series }) => ({ ...series, ...distribution }))
    .filter((distribution) => distribution.rows.length > 0)
  return {
    id: 'ratio',
    kind: 'boxes',
    title: 'Length of the path, compared with the optimum',
    summary: [
      'Where the ratio of what the path cost to the least cost there is lies, for the runs that reached the goal; 1 is optimal.',
      ...distributions.map(
        ({ name, quantiles: { median, high } }) =>
          `${name}: median ${ratioInWords(median)}, 95 of 100 at most ${ratioInWords(high)}.`,
      ),
    ].join(' '),
    x: { label: 'Cost of the path / least cost', scale: 'log' },
    y: { label: '', scale: 'linear' },
    series: distributions.map(({ name, setting }) => ({ name, style: setting })),
    marks: distributions.map(({ name, quantiles, rows: reached }, series) => ({
      series,
      x: quantiles.median,
      y: series,
      low: quantiles.least,
      high: quantiles.high,
      lower: quantiles.lower,
      upper: quantiles.upper,
      label: `${name}: median ${ratioInWords(quantiles.median)}, half from ${ratioInWords(quantiles.lower)} to ${ratioInWords(quantiles.upper)}, 95 of 100 at most ${ratioInWords(quantiles.high)}, longest ${ratioInWords(quantiles.greatest)}`,
      runs: [{ title: 'Longest detours', rows: longest(reached) }],
    })),
    table: {
      columns: [
        'Planner',
        'Paths',
        'Optimal',
        'Lower quarter',
        'Median',
        'Upper quarter',
        '95 of 100',
        'Longest',
      ],
      rows: distributions.map(({ name, rows: reached, optimal, quantiles: q }) => [
        name,
        count(reached.length),
        count(optimal.length),
        ...[q.lower, q.median, q.upper, q.high, q.greatest].map(ratioInWords),
      ]),
    },
    missing: distributions.length === 0 ? 'No planner reached a goal.' : '',
  }
}

function longest(rows: readonly Row[]): Row[] {
  const ratioOf = ({ ratio }: Row) => ratio ?? 0
  return rows
    .filter((row) => ratioOf(row) > 1)
    .sort((a, b) => ratioOf(b) - ratioOf(a))
    .slice(0, LONGEST)
}
