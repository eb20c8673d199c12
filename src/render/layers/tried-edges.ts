import type { Cell } from '../../grid/grid'
import { simplestPath } from '../../grid/simplest-path'
import type { Refusal } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'
import { strokeCased, traceCircle } from './shapes'
import { drawCross } from './signs'

/** The edge that was added last: its simplest path, wider than the others, between larger ends. */
export function drawLatestEdge(
  pen: Pen,
  place: Placement,
  theme: Theme,
  from: Cell,
  to: Cell,
): void {
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  pen.strokeStyle = theme.roadmap
  pen.lineWidth = inProportion(place, 0.16, 2.5, 6)
  pen.beginPath()
  traceCells(pen, place, simplestPath(place.columns, from, to))
  pen.stroke()
  const radius = inProportion(place, 0.22, 3, 7)
  pen.fillStyle = theme.vertex
  pen.beginPath()
  for (const cell of [from, to]) {
    traceCircle(pen, centreX(place, cell), centreY(place, cell), radius)
  }
  pen.fill()
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
  strokeRefused(pen, place, theme, cells.subarray(end))
  pen.setLineDash([])
  strokeRefused(pen, place, theme, cells.subarray(0, end + 1))
  const radius = inProportion(place, 0.34, 5, 16)
  drawCross(pen, place, theme, centreX(place, at), centreY(place, at), radius)
}

function strokeRefused(pen: Pen, place: Placement, theme: Theme, cells: ArrayLike<Cell>): void {
  const { casing, failed } = theme
  const width = inProportion(place, 0.11, 2, 4.5)
  pen.lineJoin = 'round'
  pen.lineCap = 'butt'
  pen.beginPath()
  traceCells(pen, place, cells)
  strokeCased(pen, { casing, casingWidth: 2 * width, colour: failed, width })
}
