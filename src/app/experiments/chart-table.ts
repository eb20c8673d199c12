import type { Chart } from '../../charts/chart'
import { create } from '../element'

/** The numbers of a chart as a table, which is folded at first. */
export function chartTable({ table: { columns, rows }, title }: Chart): HTMLElement {
  const head = create('tr', {}, ...columns.map((name) => create('th', { scope: 'col' }, name)))
  const lines = rows.map(([first, ...others]) =>
    create(
      'tr',
      {},
      create('th', { scope: 'row' }, first),
      ...others.map((text) => create('td', {}, text)),
    ),
  )
  const table = create(
    'table',
    {},
    create('caption', { class: 'visually-hidden' }, title),
    create('thead', {}, head),
    create('tbody', {}, ...lines),
  )
  const region = create(
    'div',
    { class: 'wide-table', role: 'region', 'aria-label': `${title}, as a table`, tabindex: 0 },
    table,
  )
  return create(
    'details',
    { class: 'as-table' },
    create('summary', {}, 'The same as a table'),
    region,
  )
}
