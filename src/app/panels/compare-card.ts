import type { AnyPlanner } from '../../algorithms/planner'
import { planners } from '../../algorithms/planners'
import { COLUMNS, type SortOrder, sortEntries } from '../compare/columns'
import { isSameSubject } from '../compare/compared'
import { styleOf } from '../compare/paths'
import type { Comparison, ComparisonEntry } from '../compare/state'
import { toggleComparison, togglePath } from '../compare/transitions'
import { byId, create, setText } from '../element'
import type { State } from '../state'
import type { Store } from '../store'

/**
 * Binds the comparison's card and its button in the toolbar; returns what shows a state in them.
 * @param rearranged called when the card comes or goes
 */
export function compareCard(store: Store<State>, rearranged: () => void): (state: State) => void {
  const card = byId('comparison', HTMLElement)
  const button = byId('compare', HTMLButtonElement)
  const fault = byId('comparison-fault', HTMLParagraphElement)
  let table: ComparisonTable | null = null
  const newTable = () =>
    new ComparisonTable(byId('comparison-table', HTMLTableElement), (plannerId) =>
      store.update((state) => togglePath(state, plannerId)),
    )
  const toggle = () => store.update(toggleComparison)
  button.addEventListener('click', toggle)
  byId('comparison-close', HTMLButtonElement).addEventListener('click', () => {
    toggle()
    // The card is gone, and with it what had the focus.
    button.focus()
  })
  let shown: Comparison | null = null
  let setup: State['setup'] | null = null

  return (state) => {
    const { comparison } = state
    if (comparison === shown && state.setup === setup) return
    shown = comparison
    setup = state.setup
    button.setAttribute('aria-pressed', String(comparison.isOn))
    if (card.hidden === comparison.isOn) {
      card.hidden = !comparison.isOn
      if (comparison.isOn) unfold(card)
      rearranged()
    }
    setText(fault, comparison.fault)
    fault.hidden = comparison.fault === ''
    if (comparison.isOn) table ??= newTable()
    table?.show(comparison, ({ subject }) => isSameSubject(subject, state.setup))
  }
}

/** By its own button: on a phone the other cards make room. */
function unfold(card: HTMLElement): void {
  const fold = card.querySelector<HTMLElement>('[data-fold]')
  if (fold?.getAttribute('aria-expanded') === 'false') fold.click()
}

interface Line {
  readonly row: HTMLTableRowElement
  readonly box: HTMLInputElement
}

/** A table that is sorted by a press on the head of a column. Its rows stay the same elements. */
class ComparisonTable {
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

  /** The first press brings the least first, and names from A. */
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
    // What is moved in the page would lose the focus.
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

const SVG = 'http://www.w3.org/2000/svg'

/** A piece of the planner's line; the style sheet chooses the theme's colour. */
function swatch(plannerId: string): SVGSVGElement {
  const { colour, dash } = styleOf(plannerId)
  const svg = document.createElementNS(SVG, 'svg')
  svg.setAttribute('class', 'swatch')
  svg.setAttribute('viewBox', '0 0 34 10')
  svg.setAttribute('aria-hidden', 'true')
  svg.style.setProperty('--line-dark', colour.dark)
  svg.style.setProperty('--line-light', colour.light)
  const line = document.createElementNS(SVG, 'path')
  line.setAttribute('d', 'M0 5h34')
  line.setAttribute('stroke-dasharray', dash.map((length) => length * 2.5).join(' '))
  svg.append(line)
  return svg
}
