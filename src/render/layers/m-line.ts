import type { Cell } from '../../grid/grid'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'

/** The m-line, dashed. */
export function drawMLine(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  cells: readonly Cell[],
): void {
  if (cells.length < 2) return
  const dash = inProportion(place, 0.3, 4, 10)
  context.lineJoin = 'round'
  context.lineCap = 'butt'
  context.setLineDash([dash, 0.7 * dash])
  context.beginPath()
  traceCells(context, place, cells)
  const width = inProportion(place, 0.08, 1.5, 3)
  context.strokeStyle = theme.casing
  context.lineWidth = 2 * width
  context.stroke()
  context.strokeStyle = theme.mLine
  context.lineWidth = width
  context.stroke()
  context.setLineDash([])
}
