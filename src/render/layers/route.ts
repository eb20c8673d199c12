import type { Cell } from '../../grid/grid'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'

/** A way from cell to cell: the path that was found, or the trail of what has been walked. */
export function drawRoute(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  cells: readonly Cell[],
): void {
  if (cells.length < 2) return
  const width = inProportion(place, 0.22, 2.25, 9)
  context.lineJoin = 'round'
  context.lineCap = 'round'
  context.beginPath()
  traceCells(context, place, cells)
  context.strokeStyle = theme.casing
  context.lineWidth = width + inProportion(place, 0.1, 1.5, 4)
  context.stroke()
  context.strokeStyle = theme.path
  context.lineWidth = width
  context.stroke()
}
