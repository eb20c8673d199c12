import type { Chart, Mark } from '../../charts/chart'
import { drawChart } from '../../charts/draw'
import type { Drawing } from '../../charts/drawing'
import { drawStandalone } from '../../charts/save'
import { create } from '../element'
import { download } from '../files/download'
import { icon } from '../icons'
import { bindMarks, focusedMark, makeReachable } from './chart-marks'
import { chartTable } from './chart-table'
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
  element.append(frame, legend.element, chartTable(chart))
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
