import * as Plot from '@observablehq/plot'
import type { Box, Chart } from './chart'
import type { Drawing } from './drawing'
import { asButtons } from './marks'
import { seriesStyle } from './style'

const ROW_HEIGHT = 40

type BoxesChart = Extract<Chart, { kind: 'boxes' }>

/** A row for each series: its name, a box for half of the values, and a line for most of them. */
export function boxesOptions(chart: BoxesChart, { theme, isShown }: Drawing): Plot.PlotOptions {
  const { series, marks, x } = chart
  const shown = marks.filter((mark) => isShown(series[mark.series].name))
  const colour = (mark: Box) => seriesStyle(theme, series[mark.series].style).colour
  const name = (mark: Box) => series[mark.series].name
  const hidden = { ariaHidden: 'true' }
  return {
    height: shown.length * ROW_HEIGHT + 64,
    marginLeft: 8,
    marginRight: 16,
    marginTop: 12,
    marginBottom: 46,
    x: { type: 'log', domain: [1, 1.02 * Math.max(1.1, ...shown.map(({ high }) => high))] },
    y: { axis: null, domain: shown.map(name) },
    marks: [
      Plot.gridX({ stroke: theme.faint, strokeOpacity: 0.5, ...hidden }),
      Plot.axisX({
        label: x.label,
        labelAnchor: 'center',
        labelOffset: 40,
        labelArrow: 'none',
        ticks: 6,
        tickFormat: String,
        ...hidden,
      }),
      Plot.text(shown, {
        x: 1,
        y: name,
        text: name,
        textAnchor: 'start',
        dx: 2,
        dy: -12,
        ...hidden,
      }),
      Plot.ruleY(shown, {
        x1: 'low',
        x2: 'high',
        y: name,
        stroke: colour,
        dy: 6,
        strokeWidth: 1.5,
        ...hidden,
      }),
      Plot.barX(shown, {
        ...asButtons(shown, marks),
        x1: 'lower',
        x2: 'upper',
        y: name,
        fill: colour,
        fillOpacity: 0.45,
        stroke: colour,
        strokeWidth: 1.5,
        insetTop: 19,
        insetBottom: 5,
        // Of values that are all alike, too, there is something to be seen, and to have the focus.
        insetLeft: -1,
        insetRight: -1,
      }),
      Plot.tickX(shown, {
        x: 'x',
        y: name,
        stroke: theme.ink,
        strokeWidth: 3,
        insetTop: 17,
        insetBottom: 3,
        pointerEvents: 'none',
        ...hidden,
      }),
    ],
  }
}
