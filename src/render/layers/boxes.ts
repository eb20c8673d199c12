import type { Cell } from '../../grid/grid'
import type { Pen } from '../pen'
import { edgeX, edgeY, type Placement } from '../placement'

/** A rectangle in device pixels. */
export interface PixelBox {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/** The box around all cells between two corner cells, but never less than `least` wide and high. */
export function boxAround(place: Placement, a: Cell, b: Cell, least: number): PixelBox {
  const [ax, bx] = [a % place.columns, b % place.columns]
  const [ay, by] = [Math.floor(a / place.columns), Math.floor(b / place.columns)]
  const across = stretch(edgeX(place, Math.min(ax, bx)), edgeX(place, Math.max(ax, bx) + 1), least)
  const down = stretch(edgeY(place, Math.min(ay, by)), edgeY(place, Math.max(ay, by) + 1), least)
  return { left: across.start, top: down.start, width: across.length, height: down.length }
}

function stretch(from: number, to: number, least: number): { start: number; length: number } {
  const length = Math.max(to - from, least)
  return { start: Math.round((from + to - length) / 2), length }
}

/** The box made smaller by `by` on each side; larger if that is negative. */
export function inset({ left, top, width, height }: PixelBox, by: number): PixelBox {
  return { left: left + by, top: top + by, width: width - 2 * by, height: height - 2 * by }
}

/** Draws along the box a line of `line` device pixels upon one three times as wide. */
export function strokeBox(
  pen: Pen,
  { left, top, width, height }: PixelBox,
  line: number,
  casing: string,
  colour: string,
): void {
  pen.lineJoin = 'round'
  pen.strokeStyle = casing
  pen.lineWidth = 3 * line
  pen.strokeRect(left, top, width, height)
  pen.strokeStyle = colour
  pen.lineWidth = line
  pen.strokeRect(left, top, width, height)
}
