import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'

/** A way from cell to cell: the path that was found, or the trail of what has been walked. */
export function drawRoute(pen: Pen, place: Placement, theme: Theme, cells: Cells): void {
  if (cells.length < 2) return
  const width = inProportion(place, 0.22, 2.25, 9)
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  pen.beginPath()
  traceCells(pen, place, cells)
  pen.strokeStyle = theme.casing
  pen.lineWidth = width + inProportion(place, 0.1, 1.5, 4)
  pen.stroke()
  pen.strokeStyle = theme.path
  pen.lineWidth = width
  pen.stroke()
}
