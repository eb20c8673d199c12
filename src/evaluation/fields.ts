import { isSuccess, type Row } from '../experiments/row'
import { type FieldMap, fieldMaps } from '../experiments/summary/fields'
import { groupByNumber } from '../experiments/summary/groups'
import { distributionOf } from '../experiments/summary/ratios'
import { successOf } from '../experiments/summary/success'
import { plural } from '../grid/plural'
import { type Evidence, pairs, REPORT, type Section, select } from './evidence'
import { type HeatMap, heatMaps } from './heat-map'
import type { Figure } from './svg'
import { count, figure, ofMaps, percent, table, withInterval } from './words'

const SIMPLE = 'potential-field'
const MEMORY = 'potential-field-memory'

export function localMinimaSection(evidence: Evidence): Section {
  const random = (planner: string) =>
    select(evidence, planner, REPORT.field).filter(({ family }) => family === 'random')
  const density = ({ mapParams }: Row) => mapParams.density
  const memory = new Map(groupByNumber(random(MEMORY), density))
  const simple = groupByNumber(random(SIMPLE), density).map(([percentage, rows]) => ({
    percentage,
    own: successOf(rows),
    other: successOf(memory.get(percentage) ?? []),
  }))
  const [fewest, more] = simple
  const missed = ({ own }: (typeof simple)[number]) => percent(1 - own.rate)
  return {
    title: 'Simple potential fields are trapped early',
    claim:
      'Simple Potential Fields has proven to be too weak to be used without any adjustment. The agent gets stuck in local minimums even in scenarios with just a few obstacles.',
    body: [
      `${fewest.own.rate < 0.9 ? 'Borne out.' : 'Not borne out where obstacles are few.'} With ${fewest.percentage} % of the cells being obstacles at random, it misses ${missed(fewest)} of the goals that can be reached, with ${more.percentage} % already ${missed(more)}; each time because of a local minimum. Random obstacles, with the report's influence of 1 and repulsive value of 30:`,
      table(
        ['Density', 'simple (95 % interval)', 'with memory (95 % interval)'],
        simple.map(({ percentage, own, other }) => [
          `${percentage} %`,
          withInterval(own),
          withInterval(other),
        ]),
      ),
    ].join('\n\n'),
    figures: [],
  }
}

export function memorySection(evidence: Evidence): Section {
  const simple = select(evidence, SIMPLE, REPORT.field)
  const memory = select(evidence, MEMORY, REPORT.field)
  const both = pairs(simple, memory)
  const trapped = both.filter(([row]) => !isSuccess(row))
  const mended = trapped.filter(([, row]) => isSuccess(row)).length
  const lost = both.filter(([a, b]) => isSuccess(a) && !isSuccess(b)).length
  const { quantiles } = distributionOf(memory)
  const direct = distributionOf(simple).quantiles
  return {
    title: 'What memory mends',
    claim:
      'The reason above is exactly why *Potential Fields with Memory* has been implemented. It is just a simple addition to the Potential Fields approach, but shows significant improvements.',
    body: `${mended / trapped.length > 0.1 ? 'Borne out.' : 'Borne out, but for little.'} Over all maps the simple one succeeds in ${withInterval(successOf(simple))}, the one with memory in ${withInterval(successOf(memory))} of the cases. Memory led to the goal on ${ofMaps(mended, trapped.length)} (${percent(mended / trapped.length)}) where the simple one was trapped, and failed on ${count(lost)} where the simple one had succeeded: as long as the potential falls, both walk the same way. It ends in a dead end on the rest. The price is in the length: the ratio of the simple one, where it arrives, has a median of ${figure(direct.median)}; with memory the median is ${figure(quantiles.median)}, one path in twenty is above ${figure(quantiles.high)}, and the longest at ${figure(quantiles.greatest)}.`,
    figures: [],
  }
}

export function influenceSection(evidence: Evidence): Section {
  const maps = [SIMPLE, MEMORY].flatMap((planner) =>
    fieldMaps(select(evidence, planner).filter(({ params }) => params.influence !== 0)),
  )
  const ranges = maps.map(({ cells }) => {
    const rates = cells.flat().map((success) => success?.rate ?? Number.NaN)
    return { least: Math.min(...rates), greatest: Math.max(...rates) }
  })
  const told = maps.map((map, i) => {
    const { least, greatest } = ranges[i]
    const off = successOf(select(evidence, map.planner, { influence: 0 }))
    return `${titleOf(map)}: from ${percent(least)} to ${percent(greatest)}, and ${percent(off.rate)} without repulsion`
  })
  const spread = Math.max(...ranges.map(({ least, greatest }) => greatest - least))
  return {
    title: 'Repulsive value and influence',
    claim:
      'Strong and weak scenarios can also heavily depend on repulsive values and distance of influence of obstacles.',
    body: `${spread > 0.1 ? 'Borne out' : 'Borne out only weakly'}, over all maps by up to ${percent(spread)} of the goals. ${told.join('. ')}. The chart has the share of reachable goals that are reached.`,
    figures: [fieldFigure(maps)],
  }
}

const titleOf = ({ planner }: FieldMap): string => (planner === SIMPLE ? 'Simple' : 'With memory')

function fieldFigure(maps: readonly FieldMap[]): Figure {
  const title = 'Potential fields: success over influence and repulsive value'
  const shown = maps.map(
    (map): HeatMap => ({
      title: titleOf(map),
      columns: map.repulsiveValues.map(count),
      rows: map.influences.map((influence) => `${influence} ${plural(influence, 'cell')}`),
      shares: map.cells.map((line) => line.map((success) => success?.rate ?? 0)),
    }),
  )
  const alt = shown.map(({ title: name, shares }) => {
    const all = shares.flat()
    return `${name} from ${percent(Math.min(...all))} to ${percent(Math.max(...all))}`
  })
  return {
    name: 'field-success',
    alt: `${title}. ${alt.join('; ')}.`,
    svg: heatMaps(title, 'repulsive value', 'influence', shown),
  }
}
