import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'
import { strokeCased } from './shapes'

/** The m-line, dashed. */
export function drawMLine(pen: Pen, place: Placement, theme: Theme, cells: Cells): void {
  if (cells.length < 2) return
  const dash = inProportion(place, 0.3, 4, 10)
  pen.lineJoin = 'round'
  pen.lineCap = 'butt'
  pen.setLineDash([dash, 0.7 * dash])
  pen.beginPath()
  traceCells(pen, place, cells)
  const { casing, mLine } = theme
  const width = inProportion(place, 0.08, 1.5, 3)
  strokeCased(pen, { casing, casingWidth: 2 * width, colour: mLine, width })
  pen.setLineDash([])
}
