import type { Quantiles } from '../experiments/summary/statistics'
import { logScale } from './scale'
import { document, element, FAINT, line, STYLES, text } from './svg'

export interface Box {
  readonly name: string
  readonly quantiles: Quantiles
}

const WIDTH = 760
const LEFT = 250
const RIGHT = 730
const ROW = 36

/** For each name half of the values in a box, the median in it, and 95 of 100 up to the end of the line. */
export function boxChart(title: string, label: string, boxes: readonly Box[]): string {
  const bottom = 16 + ROW * boxes.length
  const scale = logScale([1, ...boxes.map(({ quantiles }) => quantiles.high)], LEFT, RIGHT)
  const ticks = scale.ticks.map((tick) => {
    const x = scale.place(tick)
    return `${line(x, 8, x, bottom, { stroke: FAINT })}${text(x, bottom + 20, String(tick), 'middle')}`
  })
  const rows = boxes.map(({ name, quantiles }, i) => {
    const y = 16 + ROW * i + ROW / 2
    const [least, lower, median, upper, high] = [
      quantiles.least,
      quantiles.lower,
      quantiles.median,
      quantiles.upper,
      quantiles.high,
    ].map(scale.place)
    const { colour } = STYLES[0]
    return [
      text(LEFT - 12, y + 4, name, 'end'),
      line(least, y, high, y, { stroke: colour, 'stroke-width': 2 }),
      element('rect', {
        x: lower,
        y: y - 9,
        width: upper - lower,
        height: 18,
        fill: '#b3d4ea',
        stroke: colour,
      }),
      line(median, y - 9, median, y + 9, { stroke: '#000000', 'stroke-width': 3 }),
    ].join('')
  })
  const axis = text((LEFT + RIGHT) / 2, bottom + 44, label, 'middle')
  return document(WIDTH, bottom + 56, title, [...ticks, ...rows, axis])
}
