import {
  count,
  millisecondsInWords,
  percent,
  quantileInWords,
  ratioInWords,
} from '../../charts/words'
import { inThousands } from '../../grid/thousands'
import { create } from '../element'
import { type SummaryKey, type SummaryRow, sortSummary } from './summary-table'

interface Column {
  readonly key: SummaryKey
  readonly title: string
  readonly help: string
  show(row: SummaryRow): string
}

const COLUMNS: readonly Column[] = [
  {
    key: 'name',
    title: 'Planner',
    help: 'With the parameters that the settings name',
    show: ({ name }) => name,
  },
  { key: 'runs', title: 'Runs', help: 'One on each map', show: ({ runs }) => count(runs) },
  {
    key: 'reached',
    title: 'Reached',
    help: 'Of all runs',
    show: ({ reached }) => percent(reached),
  },
  {
    key: 'reachedOfReachable',
    title: 'Of reachable',
    help: 'Of the runs on maps whose goal can be reached',
    show: ({ reachedOfReachable }) => percent(reachedOfReachable),
  },
  {
    key: 'failures',
    title: 'Failed',
    help: 'Although the goal can be reached',
    show: ({ failures }) => count(failures.length),
  },
  {
    key: 'medianRatio',
    title: 'Median ratio',
    help: 'Cost of the path divided by the least cost there is',
    show: ({ medianRatio }) => ratioInWords(medianRatio),
  },
  {
    key: 'medianLength',
    title: 'Median length',
    help: 'Euclidean, in cells, of the paths that reached the goal',
    show: ({ medianLength }) =>
      Number.isNaN(medianLength) ? '–' : inThousands(medianLength.toFixed(1)),
  },
  {
    key: 'medianMilliseconds',
    title: 'Median time',
    help: 'To plan, as far as the clock can tell',
    show: ({ medianMilliseconds, tick }) => quantileInWords(medianMilliseconds, tick),
  },
  {
    key: 'meanMilliseconds',
    title: 'Mean time',
    help: 'To plan',
    show: ({ meanMilliseconds }) => millisecondsInWords(meanMilliseconds),
  },
]

/** Shows a summary in the table, to be sorted by a press on the head of a column. */
export function showSummary(
  table: HTMLTableElement,
  rows: readonly SummaryRow[],
  openFailures: (row: SummaryRow) => void,
): void {
  const body = create('tbody')
  let sorted: { readonly key: SummaryKey; readonly descending: boolean } | null = null

  const heads = COLUMNS.map(({ key, title, help }) => {
    const button = create('button', { type: 'button', title: help }, title)
    const head = create('th', { scope: 'col', 'aria-sort': 'none' }, button)
    button.addEventListener('click', () => {
      // The first press brings the names from A, and the greatest numbers.
      const descending = sorted?.key === key ? !sorted.descending : key !== 'name'
      sorted = { key, descending }
      for (const other of heads) other.setAttribute('aria-sort', 'none')
      head.setAttribute('aria-sort', descending ? 'descending' : 'ascending')
      fill(sortSummary(rows, key, descending))
    })
    return head
  })

  const fill = (ordered: readonly SummaryRow[]) => {
    body.replaceChildren(...ordered.map((row) => lineOf(row, openFailures)))
  }
  fill(rows)
  table.replaceChildren(
    create('caption', { id: 'summary-caption', class: 'visually-hidden' }, 'Results by planner'),
    create('thead', {}, create('tr', {}, ...heads)),
    body,
  )
}

function lineOf(row: SummaryRow, openFailures: (row: SummaryRow) => void): HTMLElement {
  const cells = COLUMNS.map((column) => {
    const text = column.show(row)
    if (column.key === 'name') return create('th', { scope: 'row' }, text)
    if (column.key !== 'failures' || row.failures.length === 0) return create('td', {}, text)
    const button = create(
      'button',
      {
        type: 'button',
        class: 'number-button',
        'aria-label': `${text} failed, ${row.name}: look at them`,
      },
      text,
    )
    button.addEventListener('click', () => openFailures(row))
    return create('td', {}, button)
  })
  return create('tr', {}, ...cells)
}
