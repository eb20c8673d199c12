import type { Cell } from '../../grid/grid'
import { simplestPath } from '../../grid/simplest-path'
import type { Refusal } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'
import { drawCross } from './signs'

/** The edge that was added last: its simplest path, as wide as a path and in the roadmap's colour. */
export function drawLatestEdge(
  pen: Pen,
  place: Placement,
  theme: Theme,
  from: Cell,
  to: Cell,
): void {
  strokeTry(pen, place, theme, theme.roadmap, simplestPath(place.columns, from, to))
}

/** A simplest path that is refused: drawn up to a cross where it is, and dashed from there on. */
export function drawRefusal(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { from, to, at }: Refusal,
): void {
  const cells = simplestPath(place.columns, from, to)
  const end = cells.indexOf(at)
  const dash = inProportion(place, 0.2, 3, 7)
  pen.setLineDash([dash, 1.2 * dash])
  strokeTry(pen, place, theme, theme.failed, cells.subarray(end))
  pen.setLineDash([])
  strokeTry(pen, place, theme, theme.failed, cells.subarray(0, end + 1))
  const radius = inProportion(place, 0.34, 5, 16)
  drawCross(pen, place, theme, centreX(place, at), centreY(place, at), radius)
}

function strokeTry(
  pen: Pen,
  place: Placement,
  theme: Theme,
  colour: string,
  cells: ArrayLike<Cell>,
): void {
  const width = inProportion(place, 0.11, 2, 4.5)
  pen.lineJoin = 'round'
  pen.lineCap = 'butt'
  pen.beginPath()
  traceCells(pen, place, cells)
  pen.strokeStyle = theme.casing
  pen.lineWidth = 2 * width
  pen.stroke()
  pen.strokeStyle = colour
  pen.lineWidth = width
  pen.stroke()
}
