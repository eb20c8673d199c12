import * as Plot from '@observablehq/plot'
import type { Axis, Chart, Mark } from './chart'
import type { Drawing } from './drawing'
import { frameOf, logTicks, type Range } from './log-axis'
import { asButtons } from './marks'
import { seriesStyle } from './style'
import { count } from './words'

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
  const frame = frameOf(shown)
  // A logarithm has no place for no samples at all.
  const hasZero = chart.x.scale === 'log' && marks.some(({ x }) => x === 0)
  // Nor has it one for intervals that begin at 0: they begin at the edge.
  const low = (mark: Mark) => (chart.y.scale === 'log' ? Math.max(mark.low, frame[0]) : mark.low)
  const intervals = { x: 'x', y1: low, y2: 'high', stroke: colour, ariaHidden: 'true' }
  return {
    height: 380,
    marginTop: 34,
    marginLeft: 52,
    marginRight: 16,
    marginBottom: 46,
    insetLeft: 10,
    insetRight: 10,
    x: { ...scaleOf(chart.x), ...(hasZero && { type: 'symlog' }) },
    y: scaleOf(chart.y, frame),
    marks: [
      ...axes(chart, frame, theme.faint),
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

function axes({ x, y, marks }: LinesChart, frame: Range, faint: string): Plot.Markish[] {
  const hidden = { ariaHidden: 'true' }
  const axisX = {
    label: x.label,
    labelAnchor: 'center',
    labelOffset: 40,
    labelArrow: 'none',
  } as const
  const axisY = { label: y.label, labelArrow: 'none', ...hidden } as const
  const grid = { stroke: faint, strokeOpacity: 0.5, ...hidden }
  // A logarithmic axis has ticks at the values that were run, where few of its own would fall.
  const places = [...new Set(marks.map((mark) => mark.x))]
  const ticks = y.scale === 'log' ? logTicks(frame) : []
  return [
    x.scale === 'log' && places.length < 9
      ? Plot.axisX(places, { ...axisX, text: count, ...hidden })
      : Plot.axisX({ ...axisX, ...hidden }),
    ...(y.scale === 'log'
      ? [Plot.gridY(ticks, grid), Plot.axisY(ticks, { ...axisY, text: count })]
      : [
          Plot.gridY(grid),
          Plot.axisY({ ...axisY, ...(y.scale === 'percent' && { tickFormat: wholePercent }) }),
        ]),
  ]
}

const wholePercent = (share: number): string => `${Math.round(100 * share)} %`

function scaleOf({ scale }: Axis, frame?: Range): Plot.ScaleOptions {
  if (scale === 'percent') return { domain: [0, 1] }
  if (scale === 'linear') return { nice: true }
  return { type: 'log', ...(frame ? { domain: frame } : {}) }
}
