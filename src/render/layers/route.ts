import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'
import { strokeCased } from './shapes'

/** A way from cell to cell: the path that was found, or the trail of what has been walked. */
export function drawRoute(pen: Pen, place: Placement, theme: Theme, cells: Cells): void {
  if (cells.length < 2) return
  const { casing, path } = theme
  const width = inProportion(place, 0.22, 2.25, 9)
  const casingWidth = width + inProportion(place, 0.1, 1.5, 4)
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  pen.beginPath()
  traceCells(pen, place, cells)
  strokeCased(pen, { casing, casingWidth, colour: path, width })
}
