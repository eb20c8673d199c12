import type { AnyPlanner } from '../../algorithms/planner'
import { planners } from '../../algorithms/planners'
import { COLUMNS, type SortOrder, sortEntries } from '../compare/columns'
import { styleOf } from '../compare/paths'
import type { Comparison, ComparisonEntry } from '../compare/state'
import { create, createSvg, setText } from '../element'

interface Line {
  readonly row: HTMLTableRowElement
  readonly box: HTMLInputElement
}

/** A table that is sorted by a press on the head of a column. Its rows stay the same elements. */
export class ComparisonTable {
  readonly #body = create('tbody')
  readonly #heads: readonly HTMLElement[]
  /** By planner; there from the beginning, so that the card has its height at once. */
  readonly #lines: ReadonlyMap<string, Line>
  #order: SortOrder | null = null
  #entries: readonly ComparisonEntry[] = []

  constructor(table: HTMLTableElement, toggle: (plannerId: string) => void) {
    this.#lines = new Map(planners.map((planner) => [planner.id, lineOf(planner, toggle)]))
    this.#heads = COLUMNS.map(({ title, help }, column) => {
      const button = create('button', { type: 'button', title: help }, title)
      button.addEventListener('click', () => this.#sortBy(column))
      return create('th', { scope: 'col', 'aria-sort': 'none' }, button)
    })
    table.append(
      create('caption', { class: 'visually-hidden' }, 'All planners on the map on screen'),
      create('thead', {}, create('tr', {}, ...this.#heads)),
      this.#body,
    )
  }

  show({ entries, hidden }: Comparison, isCurrent: (entry: ComparisonEntry) => boolean): void {
    this.#entries = entries
    for (const [id, { row, box }] of this.#lines) {
      const entry = entries.find(({ plan }) => plan.plannerId === id)
      box.checked = !hidden.includes(id)
      row.setAttribute('aria-busy', String(!entry || !isCurrent(entry)))
      COLUMNS.slice(1).forEach((column, i) => {
        setText(row.cells[i + 1], entry ? column.show(entry) : '…')
      })
      row.cells[1].title = entry?.plan.reason ?? ''
    }
    this.#arrange()
  }

  /** The first press sorts from the least, and names from A; the next one the other way. */
  #sortBy(column: number): void {
    const descending = this.#order?.column === column && !this.#order.descending
    this.#order = { column, descending }
    this.#heads.forEach((head, i) => {
      const direction = descending ? 'descending' : 'ascending'
      head.setAttribute('aria-sort', i === column ? direction : 'none')
    })
    this.#arrange()
  }

  #arrange(): void {
    const sorted = sortEntries(this.#entries, this.#order).map(({ plan }) => plan.plannerId)
    const ids = new Set([...sorted, ...this.#lines.keys()])
    const rows = [...ids].flatMap((id) => this.#lines.get(id)?.row ?? [])
    const isArranged =
      rows.length === this.#body.rows.length && rows.every((row, i) => row === this.#body.rows[i])
    // An element that is moved in the page loses the focus.
    if (!isArranged) this.#body.replaceChildren(...rows)
  }
}

function lineOf({ id, title }: AnyPlanner, toggle: (plannerId: string) => void): Line {
  const box = create('input', { type: 'checkbox', id: `compare-${id}` })
  box.addEventListener('change', () => toggle(id))
  const label = create('label', { for: box.id }, swatch(id), title)
  const row = create('tr', {}, create('th', { scope: 'row' }, create('div', {}, box, label)))
  for (let i = 1; i < COLUMNS.length; i++) row.append(create('td'))
  return { row, box }
}

/** A piece of the planner's line; the style sheet chooses the theme's colour. */
function swatch(plannerId: string): SVGSVGElement {
  const { colour, dash } = styleOf(plannerId)
  const dashes = dash.map((length) => length * 2.5).join(' ')
  const line = createSvg('path', { d: 'M0 5h34', 'stroke-dasharray': dashes })
  const svg = createSvg(
    'svg',
    { class: 'swatch', viewBox: '0 0 34 10', 'aria-hidden': 'true' },
    line,
  )
  svg.style.setProperty('--line-dark', colour.dark)
  svg.style.setProperty('--line-light', colour.light)
  return svg
}
