import type { Chart, Mark } from '../../charts/chart'
import { type Drawing, drawChart } from '../../charts/draw'
import { MARK_ATTRIBUTE } from '../../charts/marks'
import { drawStandalone } from '../../charts/save'
import { download } from '../download'
import { create } from '../element'
import { icon } from '../icons'
import { Legend } from './legend'

export interface ChartEvents {
  /** A mark was pressed. */
  opened(mark: Mark): void
  /** A series is to be shown or left out. */
  toggled(series: string): void
}

export interface ChartCard {
  readonly element: HTMLElement
  /** Where the chart goes; its width is that of the drawing. */
  readonly frame: HTMLElement
  draw(drawing: Drawing): void
}

/** How far from a mark a press still counts, in pixels. */
const REACH = 22

/** A chart with its title, its legend, the same as a table, and a way to save it. */
export function chartCard(chart: Chart, note: string, events: ChartEvents): ChartCard {
  const frame = create('div', { class: 'chart-frame' })
  const legend = new Legend(chart, events.toggled)
  const title = create('h3', { id: `chart-${chart.id}` }, chart.title)
  const head = create('header', { class: 'pane-head' }, title)
  const element = create('section', { class: 'chart', 'aria-labelledby': title.id }, head)
  if (chart.missing) {
    element.append(create('p', { class: 'help' }, chart.missing))
    return { element, frame, draw: () => {} }
  }

  let drawn: Drawing | null = null
  const save = create('button', { type: 'button', class: 'btn text compact' })
  save.append(icon('download'), 'SVG')
  save.setAttribute('aria-label', `Save “${chart.title}” as SVG`)
  save.addEventListener('click', () => {
    if (!drawn) return
    const text = new XMLSerializer().serializeToString(drawStandalone(chart, drawn, note))
    download(text, 'image/svg+xml', `path-planner-${chart.id}.svg`)
  })
  head.append(save)
  element.append(frame, legend.element, tableOf(chart))
  bindMarks(frame, chart.marks, events.opened)

  return {
    element,
    frame,
    draw(drawing) {
      drawn = drawing
      const focused = focusedMark(frame)
      const picture = drawChart(chart, drawing)
      frame.replaceChildren(picture)
      makeReachable(frame, focused)
      legend.show(drawing)
    },
  }
}

const marksIn = (frame: Element): SVGElement[] => [
  ...frame.querySelectorAll<SVGElement>(`[${MARK_ATTRIBUTE}]`),
]

const numberOf = (element: Element | null): number =>
  Number(element?.getAttribute(MARK_ATTRIBUTE) ?? Number.NaN)

function focusedMark(frame: Element): number | null {
  const { activeElement } = document
  return activeElement && frame.contains(activeElement) ? numberOf(activeElement) : null
}

/** One mark is in the order of the tabulator; the arrow keys lead to the others. */
function makeReachable(frame: Element, focused: number | null): void {
  const elements = marksIn(frame)
  const entry = elements.find((element) => numberOf(element) === focused) ?? elements[0]
  entry?.setAttribute('tabindex', '0')
  if (focused !== null) entry?.focus()
}

/** Marks open by a press on or near them, by Enter and by Space; arrows go from one to the next. */
function bindMarks(frame: HTMLElement, marks: readonly Mark[], opened: (mark: Mark) => void): void {
  const open = (element: Element | null) => {
    const mark = marks[numberOf(element)]
    if (mark) opened(mark)
  }
  frame.addEventListener('click', ({ clientX, clientY }) =>
    open(nearestMark(frame, clientX, clientY)),
  )
  frame.addEventListener('keydown', (event) => {
    const here = document.activeElement
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault()
      return open(here)
    }
    const elements = marksIn(frame)
    const from = elements.findIndex((element) => numberOf(element) === numberOf(here))
    const to = elements[indexAfter(event.key, from, elements.length)]
    if (from < 0 || !to || to === here || !(event.key in STEPS)) return
    event.preventDefault()
    here?.setAttribute('tabindex', '-1')
    to.setAttribute('tabindex', '0')
    to.focus()
  })
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
}

const indexAfter = (key: string, from: number, length: number): number =>
  Math.min(length - 1, Math.max(0, from + (STEPS[key] ?? 0)))

function nearestMark(frame: Element, x: number, y: number): Element | null {
  let nearest: Element | null = null
  let least = REACH
  for (const element of marksIn(frame)) {
    const { left, right, top, bottom } = element.getBoundingClientRect()
    // 0 for a press inside; between marks that lie close the one whose middle is nearer wins.
    const dx = Math.max(left - x, 0, x - right)
    const dy = Math.max(top - y, 0, y - bottom)
    const distance =
      Math.hypot(dx, dy) + Math.hypot(x - (left + right) / 2, y - (top + bottom) / 2) / 1e4
    if (distance >= least) continue
    least = distance
    nearest = element
  }
  return nearest
}

function tableOf({ table: { columns, rows }, title }: Chart): HTMLElement {
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
