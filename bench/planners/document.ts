import { lineChart } from '../../src/evaluation/line-chart'
import { logScale } from '../../src/evaluation/scale'
import type { Figure } from '../../src/evaluation/svg'
import { count, figure, table } from '../../src/evaluation/words'
import type { Checked } from './checked'
import { byContender, faultInWords } from './faults'
import { aDoubling, type Growth, isGrowthMet, MOST_A_DOUBLING, searchers, walkers } from './growth'
import type { Result } from './timed'
import { COLUMNS, columnsOf, digits } from './words'

export interface SpeedDocument {
  readonly markdown: string
  readonly figures: readonly Figure[]
}

export interface Measured {
  readonly checked: Checked
  readonly results: readonly Result[]
  readonly growth: readonly Growth[]
  /** What it was measured on, in words. */
  readonly machine: string
}

/**
 * What the bench measured, as a document.
 * @param folder where the drawings will be, as seen from the document
 */
export function speedDocument(measured: Measured, folder: string): SpeedDocument {
  const { checked, results, growth, machine } = measured
  const of = (growers: readonly Growth['grower'][]) =>
    growth.filter(({ grower }) => growers.includes(grower))
  const figures = [
    growthFigure('growth-searches', 'Planners that search a graph', of(searchers)),
    growthFigure('growth-walks', 'Fields and Bugs', of(walkers)),
  ]
  const shown = figures.map(({ alt, name }) => `![${alt}](${folder}/${name}.svg)`)
  const parts = [
    introduction(machine),
    '## Who is right',
    checkInMarkdown(checked),
    '## Ratios',
    ratiosInMarkdown(results),
    '## Growth',
    growthIntroduction,
    growthTable(growth),
    ...shown,
  ]
  return { markdown: `${parts.join('\n\n')}\n`, figures }
}

const introduction = (machine: string): string => `# How fast

This page is written by \`npm run bench -- --docs\`. The bench runs our planners and those of other
libraries in turn (A B A B) in one process: ours as the built library, from a plain array of obstacles
to the checked answer; theirs with what they need anew for each query, such as a grid that
serves one query only, but without what they can keep. Ours keep what they found out about the map before, its legal steps and
the jumps on it, and each query pays for comparing the maps cell by cell. All answers are compared before anything is timed. Times are medians; the ratio is the median of the ratios of neighbouring
samples, beside its quartiles.

Most lines ask the same few queries on one map again and again. In those that begin with \`first query on a map\`
nothing that ours keep is of use, because no two queries in a row are on the same map: they are on the map and on the
map turned by 180 degrees in turn, which has a row of obstacles more at its end, so that open maps differ, too. The peers
are asked the same in the same order; Dijkstra's algorithm is left out on large maps, where it takes seconds.

In those that begin with \`nothing to search\` ours are only asked for the way to the second cell of each path, the
peers for whole paths. So they show what a ratio would be if a search took no time: what is left is to check
the question and the answer, and to compare the maps.

Measured with ${machine}. The ratios say more than the times: they hold on other machines too.

Maps come from this project's generators: \`random\` has 20 % obstacles, \`rooms\` and \`maze\` are the
defaults (rooms of at least 5 cells a side, corridors 1 cell wide), \`large rooms\` are of at least 30
cells a side, the corridors of a \`wide maze\` are 8 cells wide, \`open\` has no obstacle. Starts and goals are random, at least three quarters of the longer
side apart, and joined by a path. The diagonal rule is \`only-when-no-obstacles\`; the cost is
\`euclidean\` if nothing else is said.`

function checkInMarkdown({ queries, faults }: Checked): string {
  const lines = byContender(faults).map(
    ({ who, count: wrong, worst }) =>
      `- ${who}: ${wrong} wrong, the worst ${faultInWords(worst)}, on ${worst.map.origin}`,
  )
  return `All were asked ${count(queries)} queries, the peers that take long on large maps fewer of those
or none, and held against a plain Dijkstra. Ours gave the least cost each time, by every search. Peers that
did not, under this rule and set up as they are here:

${lines.join('\n')}`
}

function ratiosInMarkdown(results: readonly Result[]): string {
  const bound = results.filter(({ one }) => one.target !== null)
  const met = bound.filter(({ figures }) => figures.met)
  const rows = results.map(({ one, figures }) => columnsOf(one, figures))
  return `${met.length} of ${bound.length} targets are met. With ≥ a target says how many times as fast as the peer ours must be, with ≤ how many
times the peer's time it may take. \`built without tapes\` is this library once more, with all that
writes on a tape left out of its searches. Two builds of one source, each compiled as it runs, differ by a few percent,
so that less than 1.1 times is taken for nothing.

${table([...COLUMNS], rows)}`
}

const growthIntroduction = `Random maps with 20 % obstacles, from 64 × 64 to 2048 × 2048 cells, three of each size; from one end of
what can be reached to the other. Who takes more than two seconds is not asked for larger ones. The
exponent is that of the power of the number of cells that fits the medians best. Decomposition by
\`dijkstra\` and potential fields look at every cell once, so twice as many cells must take twice as
long, within the limits of the processor's caches: at most ${MOST_A_DOUBLING} times.`

function growthTable(growth: readonly Growth[]): string {
  const sides = [64, 512, 2048]
  const header = [
    'planner',
    ...sides.map((side) => `${side} × ${side}`),
    'exponent',
    'a doubling',
    '',
  ]
  const rows = growth.map((one) => [
    one.grower.name,
    ...sides.map((wanted) => {
      const point = one.points.find(({ side }) => side === wanted)
      return point ? `${digits(point.median)} ms` : '–'
    }),
    one.exponent.toFixed(2),
    `×${digits(aDoubling(one))}`,
    one.grower.isLinear ? (isGrowthMet(one) ? 'met' : 'MISSED') : '',
  ])
  return table(header, rows)
}

function growthFigure(name: string, what: string, growth: readonly Growth[]): Figure {
  const lines = growth.map(({ grower, points }) => ({
    // There is little room beside the drawing.
    name: grower.name.replace('probabilistic-', ''),
    points: points.map(({ side, least, median, greatest }) => ({
      x: side * side,
      y: median,
      low: least,
      high: greatest,
    })),
  }))
  const all = lines.flatMap(({ points }) => points)
  const title = `${what}: time over the number of cells, both logarithmic`
  const summary = growth
    .map(({ grower, exponent }) => `${grower.name} by the power of ${exponent.toFixed(2)}`)
    .join(', ')
  const svg = lineChart(
    title,
    {
      label: 'cells of the map',
      scale: (from, to) =>
        logScale(
          all.map(({ x }) => x),
          from,
          to,
        ),
      write: (cells) => (/^1/.test(String(cells)) ? count(cells) : ''),
    },
    {
      label: 'milliseconds',
      scale: (from, to) =>
        logScale(
          all.flatMap(({ low, high }) => [low, high]),
          from,
          to,
        ),
      write: figure,
    },
    lines,
  )
  return { name, alt: `${title}. ${summary}.`, svg }
}
