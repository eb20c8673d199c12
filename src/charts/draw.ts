import * as Plot from '@observablehq/plot'
import type { Chart } from './chart'
import { boxesOptions } from './draw-boxes'
import { cellsOptions } from './draw-cells'
import { linesOptions } from './draw-lines'
import type { Drawing } from './drawing'

const FONTS = 'system-ui, sans-serif'

/** The chart as a picture. Each mark in it is a button with its number as `data-mark`. */
export function drawChart(chart: Chart, drawing: Drawing): SVGSVGElement {
  const { width, theme, document } = drawing
  const picture = Plot.plot({
    ...optionsOf(chart, drawing),
    width,
    ariaLabel: `${chart.title}. ${chart.summary}`,
    style: {
      background: theme.surface,
      color: theme.ink,
      fontSize: '12px',
      fontFamily: FONTS,
      overflow: 'visible',
    },
    ...(document && { document }),
  }) as Element as SVGSVGElement
  // The buttons in it could not be reached if it were an image.
  picture.setAttribute('role', 'group')
  return picture
}

function optionsOf(chart: Chart, drawing: Drawing): Plot.PlotOptions {
  switch (chart.kind) {
    case 'lines':
      return linesOptions(chart, drawing)
    case 'boxes':
      return boxesOptions(chart, drawing)
    case 'cells':
      return cellsOptions(chart, drawing)
  }
}
