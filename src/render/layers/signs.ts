import type { Pen } from '../pen'
import type { Placement } from '../placement'
import { inProportion } from '../placement'
import type { Theme } from '../theme'

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
  const line = inProportion(place, 0.09, 1.75, 4)
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  pen.strokeStyle = casing
  pen.lineWidth = 2.2 * line
  pen.stroke()
  pen.strokeStyle = colour
  pen.lineWidth = line
  pen.stroke()
}
