import type { Row } from '../experiments/row'
import { fieldMaps } from '../experiments/summary/fields'
import type { Chart } from './chart'
import { percent, successInWords } from './words'

/** Where the settings of potential fields lead to the goal, as a heat map. */
export function fieldChart(rows: readonly Row[]): Chart {
  const maps = fieldMaps(rows).filter(
    ({ influences, repulsiveValues }) => influences.length * repulsiveValues.length > 1,
  )
  const cells = maps.flatMap(({ name, influences, repulsiveValues, cells }, series) =>
    influences.flatMap((influence, i) =>
      repulsiveValues.flatMap((repulsive, k) => {
        const success = cells[i][k]
        return success && success.rows.length > 0
          ? [{ series, name, influence, repulsive, success }]
          : []
      }),
    ),
  )
  const best = [...cells].sort((a, b) => b.success.rate - a.success.rate)[0]
  return {
    id: 'field',
    kind: 'cells',
    title: 'Potential field: success over influence and repulsive value',
    summary: best
      ? `How often the goal was reached where it can be reached. Best with ${best.name}, influence ${best.influence} and repulsive value ${best.repulsive}: ${percent(best.success.rate)}.`
      : 'No potential field was run with several settings.',
    x: { label: 'Influence (cells)', scale: 'linear' },
    y: { label: 'Repulsive value', scale: 'linear' },
    series: maps.map(({ name }, style) => ({ name, style })),
    marks: cells.map(({ series, name, influence, repulsive, success }) => ({
      series,
      x: influence,
      y: repulsive,
      low: success.low,
      high: success.high,
      value: success.rate,
      label: `${name}, influence ${influence}, repulsive value ${repulsive}: ${successInWords(success)}`,
      runs: [{ title: 'Failed', rows: success.failures }],
    })),
    table: {
      columns: ['Planner', 'Influence', 'Repulsive value', 'Reached'],
      rows: cells.map(({ name, influence, repulsive, success }) => [
        name,
        String(influence),
        String(repulsive),
        successInWords(success),
      ]),
    },
    missing:
      cells.length < 2
        ? 'It needs a potential field with several values for its influence or its repulsive value.'
        : '',
  }
}
