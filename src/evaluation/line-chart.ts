import { linearScale, type Scale } from './scale'
import { document, element, FAINT, line, px, STYLES, text } from './svg'

interface LinePoint {
  readonly x: number
  readonly y: number
  /** Ends of the interval around y. */
  readonly low: number
  readonly high: number
}

export interface Line {
  readonly name: string
  readonly points: readonly LinePoint[]
}

export interface Axis {
  readonly label: string
  readonly scale: (from: number, to: number) => Scale
  readonly write: (value: number) => string
}

const SHARES = [0, 0.2, 0.4, 0.6, 0.8, 1]

/** How many of the goals that can be reached are reached. */
export const successAxis: Axis = {
  label: 'reachable goals that are reached',
  scale: (from, to) => linearScale(SHARES, from, to),
  write: (share) => `${Math.round(100 * share)} %`,
}

const WIDTH = 760
const HEIGHT = 400
const FRAME = { left: 64, top: 16, width: 440, height: 320 } as const

/** Lines with intervals, and their names beside them. */
export function lineChart(title: string, x: Axis, y: Axis, lines: readonly Line[]): string {
  const { left, top, width, height } = FRAME
  const across = x.scale(left, left + width)
  const up = y.scale(top + height, top)
  return document(WIDTH, HEIGHT, title, [
    ...up.ticks.map((tick) => gridLine(up.place(tick), y.write(tick))),
    ...across.ticks.map((tick) =>
      text(across.place(tick), top + height + 20, x.write(tick), 'middle'),
    ),
    text(left + width / 2, top + height + 46, x.label, 'middle'),
    text(0, 0, y.label, 'middle', { transform: `translate(16 ${top + height / 2}) rotate(-90)` }),
    ...lines.map((one, i) => drawLine(one, i, across, up)),
    ...lines.map(({ name }, i) => legendLine(name, i)),
  ])
}

function gridLine(y: number, words: string): string {
  const { left, width } = FRAME
  return `${line(left, y, left + width, y, { stroke: FAINT })}${text(left - 8, y + 4, words, 'end')}`
}

function drawLine({ points }: Line, number: number, across: Scale, up: Scale): string {
  const { colour, dash } = STYLES[number % STYLES.length]
  const places = points.map(({ x, y }) => `${px(across.place(x))},${px(up.place(y))}`)
  const stroke = {
    stroke: colour,
    fill: 'none',
    'stroke-width': 2,
    'stroke-dasharray': dash || 'none',
  }
  const intervals = points.map(({ x, low, high }) => {
    const at = across.place(x)
    return line(at, up.place(low), at, up.place(high), { stroke: colour, 'stroke-width': 1 })
  })
  const dots = points.map(({ x, y }) =>
    element('circle', { cx: across.place(x), cy: up.place(y), r: 3, fill: colour }),
  )
  return [element('polyline', { points: places.join(' '), ...stroke }), ...intervals, ...dots].join(
    '',
  )
}

function legendLine(name: string, number: number): string {
  const { colour, dash } = STYLES[number % STYLES.length]
  const x = FRAME.left + FRAME.width + 20
  const y = FRAME.top + 14 + 24 * number
  const stroke = { stroke: colour, 'stroke-width': 2, 'stroke-dasharray': dash || 'none' }
  return `${line(x, y, x + 28, y, stroke)}${text(x + 36, y + 4, name)}`
}
