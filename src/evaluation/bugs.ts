import type { Row } from '../experiments/row'
import { groupBy } from '../experiments/summary/groups'
import { distributionOf } from '../experiments/summary/ratios'
import { quantilesOf } from '../experiments/summary/statistics'
import { successOf } from '../experiments/summary/success'
import { boxChart } from './box-chart'
import { compareSteps, type Evidence, REPORT, type Section, select } from './evidence'
import type { Figure } from './svg'
import { count, figure, list, ofMaps, percent, table, withInterval } from './words'

const bugsOf = (evidence: Evidence) => ({
  bug1: select(evidence, 'bug1'),
  bug2: select(evidence, 'bug2', REPORT.bug2),
  closer: select(evidence, 'bug2', { leave: 'closer' }),
  tangent: select(evidence, 'tangent-bug', REPORT.tangentBug),
  classic: select(evidence, 'tangent-bug', { variant: 'classic', range: 2 }),
})

const loopsOf = (rows: readonly Row[]) =>
  rows.filter(({ reachable, status }) => reachable && status === 'loop').length

export function bug1Section(evidence: Evidence): Section {
  const { bug1 } = bugsOf(evidence)
  const { rows: possible, failures } = successOf(bug1)
  const proofs = bug1.filter(({ status }) => status === 'unreachable').length
  const { quantiles, optimal } = distributionOf(bug1)
  return {
    title: 'Bug1 is complete, and walks far',
    claim: 'Bug v1, despite using a naive approach and therefore being non optimal, is complete',
    body: `${failures.length === 0 ? 'Borne out.' : 'Not borne out.'} It arrived on ${ofMaps(possible.length - failures.length, possible.length)} where that is possible, and proved of the other ${count(proofs)} that it is not. ${percent(optimal.length / possible.length)} of its walks have the least number of steps; the median is ${figure(quantiles.median)} times that number, one in twenty more than ${figure(quantiles.high)}, and the longest ${figure(quantiles.greatest)} times.`,
    figures: [ratioFigure(evidence)],
  }
}

export function bug2Section(evidence: Evidence): Section {
  const { bug1, bug2, closer } = bugsOf(evidence)
  const { maps, shorter, equal, longer } = compareSteps(bug2, bug1)
  const fixed = compareSteps(closer, bug1)
  const possible = successOf(bug2)
  const loops = loopsOf(bug2)
  const others = possible.failures.length - loops
  const complete = successOf(closer)
  return {
    title: 'Bug2 is shorter, and can loop',
    claim:
      'compared to Bug v2, the latter is able to find shorter paths, as shown in Fig. 11. Nevertheless, this performance improvement has a cost, since in some configuration Bug v2 can get stuck in loop while searching for path to the destination',
    body: [
      `Both ${shorter > longer && loops > 0 ? 'borne out' : 'only partly borne out'}. Where both arrive (${count(maps)} maps), Bug2 walks less than Bug1 on ${percent(shorter)}, the same on ${percent(equal)} and more on ${percent(longer)}. On ${ofMaps(loops, possible.rows.length)} (${percent(loops / possible.rows.length)}) whose goal can be reached it goes round for ever${others > 0 ? `, and on ${count(others)} it ends otherwise` : ''}.`,
      `The cure is Lumelsky and Stepanov's: leave the boundary only further along the m-line (\`closer\`). With it, Bug2 arrived on ${ofMaps(complete.rows.length - complete.failures.length, complete.rows.length)}. It walks less than Bug1 on ${percent(fixed.shorter)} of them and more on ${percent(fixed.longer)}.`,
      loopTable(evidence),
    ].join('\n\n'),
    figures: [],
  }
}

function loopTable(evidence: Evidence): string {
  const { bug2, tangent } = bugsOf(evidence)
  const byFamily = groupBy(bug2, ({ family }) => family)
  const share = (rows: readonly Row[]) =>
    percent(loopsOf(rows) / rows.filter(({ reachable }) => reachable).length)
  return table(
    ['Loops, of reachable goals', 'Bug2 (report)', 'Tangent Bug (report, range 2)'],
    [...byFamily].map(([family, rows]) => [
      family,
      share(rows),
      share(tangent.filter((row) => row.family === family)),
    ]),
  )
}

export function tangentBugSection(evidence: Evidence): Section {
  const { bug2, closer, tangent, classic } = bugsOf(evidence)
  const report = compareSteps(tangent, bug2)
  const better = compareSteps(classic, closer)
  const success = successOf(tangent)
  const loops = loopsOf(tangent)
  const complete = successOf(classic)
  const ranges = [...new Set(select(evidence, 'tangent-bug').map(({ params }) => params.range))]
  return {
    title: 'Tangent Bug is shorter still, mostly, and can loop',
    claim:
      'The implementation of Tangent Bug can find even shorter paths compared to Bug v2 (as shown in Fig. 13), but similarly it can sometimes get stuck in loops. Also, it can happen that the goal path found by Tangent Bug results longer than the one found by Bug v2, as shown in Fig. 14.',
    body: [
      `${report.shorter > 0 && report.longer > 0 && loops > 0 ? 'All three borne out.' : 'Not all three were seen.'} The report's variant, with its range of 2, on ${count(report.maps)} maps where it and Bug2 arrive: shorter on ${percent(report.shorter)}, the same on ${percent(report.equal)}, longer on ${percent(report.longer)}. It ends in a loop on ${ofMaps(loops, success.rows.length)} (${percent(loops / success.rows.length)}) whose goal can be reached.`,
      `The classic variant of Kamon, Rimon and Rivlin is complete: it arrived on ${ofMaps(complete.rows.length - complete.failures.length, complete.rows.length)}. Beside Bug2 with \`closer\`, which arrives on all of them too, it is shorter on ${percent(better.shorter)} and longer on ${percent(better.longer)}. By the range of the sensor:`,
      table(
        [
          'Range',
          'report: reached (95 % interval)',
          'report: median ratio',
          'classic: reached',
          'classic: median ratio',
        ],
        ranges.map((range) => {
          const cells = (['report', 'classic'] as const).flatMap((variant) => {
            const rows = select(evidence, 'tangent-bug', { variant, range })
            const { quantiles } = distributionOf(rows)
            const reached = successOf(rows)
            return [
              variant === 'report' ? withInterval(reached) : percent(reached.rate),
              figure(quantiles.median),
            ]
          })
          return [String(range), ...cells]
        }),
      ),
    ].join('\n\n'),
    figures: [],
  }
}

export function boundsSection(evidence: Evidence): Section {
  const { bug1, closer } = bugsOf(evidence)
  const told = (
    [
      ['Bug1', bug1],
      ['Bug2 (`closer`)', closer],
    ] as const
  ).map(([name, rows]) => {
    const shares = quantilesOf(rows.map(({ steps, bound }) => steps / (bound ?? Number.NaN)))
    const above = rows.filter(({ steps, bound }) => steps > (bound ?? Number.POSITIVE_INFINITY))
    return {
      above: above.length,
      row: [
        name,
        count(rows.length),
        count(above.length),
        ...[shares.median, shares.high, shares.greatest].map(percent),
      ],
    }
  })
  const broken = told.filter(({ above }) => above > 0).length
  return {
    title: 'How far they may walk',
    claim: '',
    body: [
      `The report says nothing of it, but V. J. Lumelsky and A. A. Stepanov do ("Path-planning strategies for a point mobile automaton moving amidst unknown obstacles of arbitrary shape", Algorithmica 2, 1987): Bug1 walks at most D + 1.5 Σ pᵢ steps, Bug2 at most D + ½ Σ nᵢ pᵢ, where D is the distance from start to goal, pᵢ the perimeter of an obstacle that it meets, and nᵢ how often the m-line enters or leaves it. On the grid both hold, counted in steps along boundaries, with one exception for Bug1: where it proves a goal unreachable it may walk once more around the last obstacle, because two obstacles can touch one cell and it has to see that this is the same one. Walked, as a share of the bound on the same map:`,
      table(
        ['', 'runs', 'above the bound', 'median', '95 of 100 below', 'most'],
        told.map(({ row }) => row),
      ),
      broken === 0
        ? 'No run was above its bound.'
        : 'That must not happen: it is a fault of this program.',
    ].join('\n\n'),
    figures: [],
  }
}

function ratioFigure(evidence: Evidence): Figure {
  const { bug1, bug2, closer, tangent, classic } = bugsOf(evidence)
  const shown = [
    ['Visibility graph', select(evidence, 'visibility-graph')],
    ['Roadmap, 80 samples', select(evidence, 'probabilistic-roadmap', { samples: 80 })],
    ['Potential field', select(evidence, 'potential-field', REPORT.field)],
    ['Potential field with memory', select(evidence, 'potential-field-memory', REPORT.field)],
    ['Bug1', bug1],
    ['Bug2 (report)', bug2],
    ['Bug2 (closer)', closer],
    ['Tangent Bug (report, range 2)', tangent],
    ['Tangent Bug (classic, range 2)', classic],
  ] as const
  const boxes = shown.map(([name, rows]) => ({ name, quantiles: distributionOf(rows).quantiles }))
  const title = 'Steps of the paths that reach the goal, divided by the least number of steps'
  const medians = boxes.map(({ name, quantiles }) => `${name} ${figure(quantiles.median)}`)
  return {
    name: 'ratio',
    alt: `${title}. Medians: ${list(medians)}.`,
    svg: boxChart(
      title,
      'times the least number of steps: median, half of the paths, 95 of 100',
      boxes,
    ),
  }
}
