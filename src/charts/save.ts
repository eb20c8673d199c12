import type { Chart } from './chart'
import { drawChart } from './draw'
import type { Drawing } from './drawing'
import { drawSwatch, SWATCH_HEIGHT, SWATCH_WIDTH } from './legend'

const SVG = 'http://www.w3.org/2000/svg'
const MARGIN = 16
/** A chart on a phone is narrower than its title. */
const LEAST_WIDTH = 600
const LINE = 20

/**
 * The chart as a picture that stands alone: with its title, what its lines mean, and its source.
 * @param note where the numbers come from
 */
export function drawStandalone(chart: Chart, drawing: Drawing, note: string): SVGSVGElement {
  const { theme, isShown, document: page = document } = drawing
  const chartWidth = Math.max(drawing.width, LEAST_WIDTH)
  const width = chartWidth + 2 * MARGIN
  const chartTop = MARGIN + 24
  const picture = drawChart(chart, { ...drawing, width: chartWidth })
  const chartHeight = Number(picture.getAttribute('height'))

  const svg = page.createElementNS(SVG, 'svg') as SVGSVGElement
  const put = (element: SVGElement, x: number, y: number) => {
    element.setAttribute('x', String(x))
    element.setAttribute('y', String(y))
    svg.append(element)
  }
  const write = (text: string, x: number, y: number, attributes: Record<string, string> = {}) => {
    const element = page.createElementNS(SVG, 'text')
    const all = { fill: theme.ink, 'font-family': 'system-ui, sans-serif', ...attributes }
    for (const [name, value] of Object.entries(all)) element.setAttribute(name, value)
    element.textContent = text
    put(element, x, y)
  }

  const surface = page.createElementNS(SVG, 'rect')
  surface.setAttribute('width', '100%')
  surface.setAttribute('height', '100%')
  surface.setAttribute('fill', theme.surface)
  svg.append(surface)
  write(chart.title, MARGIN, MARGIN + 12, { 'font-size': '16', 'font-weight': '600' })
  put(picture, MARGIN, chartTop)

  let y = chartTop + chartHeight + 8
  if (chart.kind === 'lines') {
    for (const series of chart.series.filter(({ name }) => isShown(name))) {
      put(drawSwatch(series, theme, page), MARGIN, y)
      write(series.name, MARGIN + SWATCH_WIDTH + 8, y + SWATCH_HEIGHT - 4, { 'font-size': '12' })
      y += LINE
    }
  }
  write(note, MARGIN, y + LINE, { 'font-size': '11', opacity: '0.8' })

  const height = y + LINE + MARGIN
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`)
  svg.setAttribute('width', String(width))
  svg.setAttribute('height', String(height))
  return svg
}
