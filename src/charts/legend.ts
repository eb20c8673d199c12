import * as Plot from '@observablehq/plot'
import type { Series } from './chart'
import { type ChartTheme, seriesStyle } from './style'

export const SWATCH_WIDTH = 38
export const SWATCH_HEIGHT = 16

/** A piece of a series' line with its symbol, as it is drawn in the charts. */
export function drawSwatch(series: Series, theme: ChartTheme, document?: Document): SVGSVGElement {
  const { colour, dash, symbol } = seriesStyle(theme, series.style)
  const swatch = Plot.plot({
    width: SWATCH_WIDTH,
    height: SWATCH_HEIGHT,
    margin: 0,
    axis: null,
    x: { domain: [0, 2] },
    y: { domain: [-1, 1] },
    marks: [
      Plot.line([0, 2], {
        x: (x: number) => x,
        y: 0,
        stroke: colour,
        strokeWidth: 1.75,
        strokeDasharray: dash || 'none',
      }),
      Plot.dot([1], {
        x: (x: number) => x,
        y: 0,
        r: 4.5,
        symbol,
        stroke: colour,
        fill: theme.surface,
        strokeWidth: 2,
      }),
    ],
    ...(document && { document }),
  }) as Element as SVGSVGElement
  swatch.setAttribute('aria-hidden', 'true')
  return swatch
}
