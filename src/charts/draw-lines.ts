import * as Plot from '@observablehq/plot'
import type { Axis, Chart, Mark } from './chart'
import type { Drawing } from './draw'
import { asButtons } from './marks'
import { seriesStyle } from './style'

type LinesChart = Extract<Chart, { kind: 'lines' }>

/** A line for each series, the marks on it with their intervals. */
export function linesOptions(chart: LinesChart, { theme, isShown }: Drawing): Plot.PlotOptions {
  const { series, marks } = chart
  const shown = marks.filter((mark) => isShown(series[mark.series].name))
  const style = (mark: Mark) => seriesStyle(theme, series[mark.series].style)
  const colour = (mark: Mark) => style(mark).colour
  const lines = series.map((_, number) => {
    const own = shown.filter((mark) => mark.series === number)
    if (own.length === 0) return null
    const { dash } = style(own[0])
    return Plot.line(own, {
      x: 'x',
      y: 'y',
      stroke: colour(own[0]),
      strokeWidth: 1.75,
      strokeDasharray: dash || 'none',
      ariaHidden: 'true',
    })
  })
  const intervals = { x: 'x', y1: 'low', y2: 'high', stroke: colour, ariaHidden: 'true' }
  return {
    height: 380,
    marginLeft: 52,
    marginRight: 16,
    x: scaleOf(chart.x),
    y: scaleOf(chart.y),
    marks: [
      ...axes(chart, theme.faint),
      Plot.ruleX(shown, { ...intervals, strokeWidth: 1.25, strokeOpacity: 0.8 }),
      ...lines,
      Plot.dot(shown, {
        ...asButtons(shown, marks),
        x: 'x',
        y: 'y',
        r: 4.5,
        symbol: (mark: Mark) => style(mark).symbol,
        stroke: colour,
        fill: theme.surface,
        strokeWidth: 2,
      }),
    ],
  }
}

function axes({ x, y, marks }: LinesChart, faint: string): Plot.Markish[] {
  const places = [...new Set(marks.map((mark) => mark.x))]
  // On a logarithmic axis only a few of what was run would fall on its own ticks.
  const ticks = x.scale === 'log' && places.length < 9 ? { ticks: places } : {}
  const hidden = { ariaHidden: 'true' }
  return [
    Plot.gridY({ stroke: faint, strokeOpacity: 0.5, ...hidden }),
    Plot.axisX({ label: x.label, labelAnchor: 'center', labelArrow: 'none', ...ticks, ...hidden }),
    Plot.axisY({ label: y.label, labelArrow: 'none', ...ticksOf(y), ...hidden }),
  ]
}

const ticksOf = ({ scale }: Axis): Plot.AxisYOptions =>
  scale === 'percent' ? { tickFormat: (share: number) => `${Math.round(100 * share)} %` } : {}

function scaleOf({ scale }: Axis): Plot.ScaleOptions {
  if (scale === 'percent') return { domain: [0, 1] }
  return scale === 'log' ? { type: 'log', nice: true } : { nice: true }
}
