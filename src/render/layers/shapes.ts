import type { Pen } from '../pen'

/** Adds a circle around (x, y) to the current path. */
export function traceCircle(pen: Pen, x: number, y: number, radius: number): void {
  pen.moveTo(x + radius, y)
  pen.arc(x, y, radius, 0, 2 * Math.PI)
}

/** Adds a square that stands on its corner, around (x, y), to the current path. */
export function traceDiamond(pen: Pen, x: number, y: number, radius: number): void {
  pen.moveTo(x, y - radius)
  pen.lineTo(x + radius, y)
  pen.lineTo(x, y + radius)
  pen.lineTo(x - radius, y)
  pen.closePath()
}

/** A line upon its casing, which makes it stand out on any cell; widths in device pixels. */
export interface CasedLine {
  readonly casing: string
  readonly casingWidth: number
  readonly colour: string
  readonly width: number
}

/** Strokes the current path twice: the casing, and the line upon it. */
export function strokeCased(pen: Pen, { casing, casingWidth, colour, width }: CasedLine): void {
  pen.strokeStyle = casing
  pen.lineWidth = casingWidth
  pen.stroke()
  pen.strokeStyle = colour
  pen.lineWidth = width
  pen.stroke()
}
