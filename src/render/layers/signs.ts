import type { Pen } from '../pen'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { strokeCased } from './shapes'

/** A tick around (x, y): this one passed. */
export function drawTick(
  pen: Pen,
  place: Placement,
  theme: Theme,
  x: number,
  y: number,
  radius: number,
): void {
  pen.beginPath()
  pen.moveTo(x - 0.9 * radius, y + 0.05 * radius)
  pen.lineTo(x - 0.25 * radius, y + 0.7 * radius)
  pen.lineTo(x + 0.9 * radius, y - 0.7 * radius)
  strokeSign(pen, place, theme.casing, theme.passed)
}

/** A cross around (x, y): this one failed. */
export function drawCross(
  pen: Pen,
  place: Placement,
  theme: Theme,
  x: number,
  y: number,
  radius: number,
): void {
  const arm = 0.75 * radius
  pen.beginPath()
  pen.moveTo(x - arm, y - arm)
  pen.lineTo(x + arm, y + arm)
  pen.moveTo(x + arm, y - arm)
  pen.lineTo(x - arm, y + arm)
  strokeSign(pen, place, theme.casing, theme.failed)
}

function strokeSign(pen: Pen, place: Placement, casing: string, colour: string): void {
  const width = inProportion(place, 0.09, 1.75, 4)
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  strokeCased(pen, { casing, casingWidth: 2.2 * width, colour, width })
}
