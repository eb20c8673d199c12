import { distributionOf } from '../experiments/summary/ratios'
import { successOf } from '../experiments/summary/success'
import { timeBySize } from '../experiments/summary/times'
import { type Evidence, REPORT, type Section, select } from './evidence'
import { lineChart } from './line-chart'
import { logScale } from './scale'
import { count, figure, milliseconds, ofMaps, percent, table } from './words'

export function decompositionSection(evidence: Evidence): Section {
  const rows = select(evidence, 'decomposition')
  const { rows: possible, failures } = successOf(rows)
  const proofs = rows.filter(({ status }) => status === 'unreachable').length
  const longer = possible.filter(({ ratio }) => ratio !== 1).length
  return {
    title: 'Decomposition is complete and optimal',
    claim:
      'The *Decomposition* methods, as implemented in this work, are obviously complete, since they are always able to find the best path to reach the destination if there is one.',
    body: `${failures.length === 0 ? 'Borne out.' : 'Not borne out.'} It reached the goal on ${ofMaps(possible.length - failures.length, possible.length)} that have a way to it, and proved of the other ${count(proofs)} that they have none. ${longer === 0 ? 'None' : count(longer)} of its paths had more cells than the least number there is. (That number comes from the same search; the tests of this project compare it with brute force.)`,
    figures: [],
  }
}

export function visibilityGraphSection(evidence: Evidence): Section {
  const rows = select(evidence, 'visibility-graph')
  const { rows: possible, failures } = successOf(rows)
  const { quantiles, optimal } = distributionOf(rows)
  const sizes = timeBySize(evidence.settings, select(evidence, 'decomposition'))[0].points.map(
    (grid, i) => {
      const graph = timeBySize(evidence.settings, rows)[0].points[i]
      return {
        name: `${grid.width} × ${grid.height}`,
        grid: grid.milliseconds,
        graph: graph.milliseconds,
      }
    },
  )
  const factors = sizes.map(({ grid, graph }) => graph.median / grid.median)
  const isCostly = Math.min(...factors) > 1
  return {
    title: 'The visibility graph is complete, and costs more',
    claim:
      'The *Visibility Graph* method is also complete. The downside of this approach is its elevated computational cost. In fact, it is necessary to scan every obstacle cell in order to discover the obstacle vertex points, then build the *dummy path* between each pair of vertices and finally apply a shortest path algorithm.',
    body: [
      `${failures.length === 0 ? 'Complete: borne out.' : 'Complete: not borne out.'} It reached the goal on ${ofMaps(possible.length - failures.length, possible.length)} that have a way to it. The report does not claim that it is optimal, and under its diagonal rule it is not: ${percent(optimal.length / possible.length)} of the paths had the least number of cells, the worst ${figure(quantiles.greatest)} times as many steps.`,
      `${isCostly ? 'Its cost: borne out' : 'Its cost: not borne out on all sizes'}, though this program does not try each pair of vertices. It walks the lines of sight of a vertex when the search comes to it, and finds paths of the same cost. Time to plan, median:`,
      table(
        ['Map', 'decomposition', 'visibility graph', 'factor'],
        sizes.map(({ name, grid, graph }, i) => [
          name,
          milliseconds(grid.median),
          milliseconds(graph.median),
          figure(factors[i]),
        ]),
      ),
    ].join('\n\n'),
    figures: [timeFigure(evidence)],
  }
}

function timeFigure(evidence: Evidence) {
  const shown = [
    ['Decomposition', select(evidence, 'decomposition')],
    ['Visibility graph', select(evidence, 'visibility-graph')],
    ['Roadmap, 80 samples', select(evidence, 'probabilistic-roadmap', { samples: 80 })],
    ['Potential field', select(evidence, 'potential-field', REPORT.field)],
    ['Bug1', select(evidence, 'bug1')],
    ['Bug2', select(evidence, 'bug2', { leave: 'closer' })],
    ['Tangent Bug, classic', select(evidence, 'tangent-bug', { variant: 'classic', range: 2 })],
  ] as const
  const lines = shown.map(([name, rows]) => ({
    name,
    points: timeBySize(evidence.settings, rows).flatMap(({ points }) =>
      points.map(({ cells, milliseconds: { lower, median, upper } }) => ({
        x: cells,
        y: median,
        low: lower,
        high: upper,
      })),
    ),
  }))
  const values = lines.flatMap(({ points }) => points.flatMap(({ low, high }) => [low, high]))
  const cells = [...new Set(lines.flatMap(({ points }) => points.map(({ x }) => x)))]
  const title = 'Time to plan over the number of cells of the map: medians and quartiles'
  const summary = lines.map(({ name, points }) => {
    const [largest] = points.slice(-1)
    return `${name} ${milliseconds(largest.y)}`
  })
  return {
    name: 'time-by-size',
    alt: `${title}. On the largest maps: ${summary.join(', ')}.`,
    svg: lineChart(
      title,
      {
        label: 'cells of the map',
        scale: (from, to) => ({ ...logScale(cells, from, to), ticks: cells }),
        write: count,
      },
      {
        label: 'milliseconds',
        scale: (from, to) =>
          logScale(
            values.filter((value) => value > 0),
            from,
            to,
          ),
        write: figure,
      },
      lines,
    ),
  }
}
