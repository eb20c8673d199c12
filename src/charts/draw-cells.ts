import * as Plot from '@observablehq/plot'
import type { Chart } from './chart'
import type { Drawing } from './drawing'
import { asButtons } from './marks'
import { percent } from './words'

type CellsChart = Extract<Chart, { kind: 'cells' }>
type CellMark = CellsChart['marks'][number]

/** A heat map for each series, below one another, each cell with its number. */
export function cellsOptions(chart: CellsChart, { isShown }: Drawing): Plot.PlotOptions {
  const { series, marks, x, y } = chart
  const shown = marks.filter((mark) => isShown(series[mark.series].name))
  const name = (mark: CellMark) => series[mark.series].name
  const names = [...new Set(shown.map(name))]
  const rows = new Set(shown.map((mark) => mark.y)).size
  const hidden = { ariaHidden: 'true' }
  const common = { fy: name, x: 'x', y: 'y' }
  return {
    height: names.length * (rows * 34 + 30) + 60,
    marginLeft: 56,
    marginTop: 30,
    marginBottom: 46,
    // The same colours in both themes: dark blue for none, yellow for all; safe for all eyes.
    color: { scheme: 'Cividis', domain: [0, 1] },
    x: { type: 'band', padding: 0.04 },
    y: { type: 'band', padding: 0.06, reverse: true },
    fy: { axis: null, domain: names, padding: 0.12 },
    marks: [
      Plot.axisX({
        label: x.label,
        labelAnchor: 'center',
        labelOffset: 36,
        labelArrow: 'none',
        tickSize: 0,
        ...hidden,
      }),
      Plot.axisY({ label: y.label, labelArrow: 'none', tickSize: 0, ...hidden }),
      Plot.text(names, {
        fy: (one: string) => one,
        text: (one: string) => one,
        frameAnchor: 'top-left',
        dy: -16,
        fontWeight: 600,
        ...hidden,
      }),
      Plot.cell(shown, { ...asButtons(shown, marks), ...common, fill: 'value', rx: 3 }),
      Plot.text(shown, {
        ...common,
        text: (mark: CellMark) => percent(mark.value),
        fill: (mark: CellMark) => (mark.value > 0.5 ? '#10141f' : '#ffffff'),
        pointerEvents: 'none',
        ...hidden,
      }),
    ],
  }
}
