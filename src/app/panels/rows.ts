import { create, setText } from '../element'
import type { NumberRow } from '../words/numbers'

/** Shows numbers in a table; it is hidden if there are none. */
export function showRows(table: HTMLTableElement, rows: readonly NumberRow[]): void {
  table.hidden = rows.length === 0
  const body = table.tBodies[0]
  rows.forEach(({ label, value }, i) => {
    const row = body.rows[i] ?? body.appendChild(newRow())
    setText(row.cells[0], label)
    setText(row.cells[1], value)
  })
  while (body.rows.length > rows.length) body.deleteRow(-1)
}

const newRow = (): HTMLTableRowElement =>
  create('tr', {}, create('th', { scope: 'row' }), create('td'))
