import type { Pen } from '../pen'
import { edgeX, edgeY, type Placement } from '../placement'
import type { Theme } from '../theme'

/** A line around the map, drawn as what the cells leave of a larger rectangle. */
export function drawBorder(pen: Pen, place: Placement, theme: Theme): void {
  const line = Math.max(1, Math.round(place.pixel))
  const left = edgeX(place, 0) - line
  const top = edgeY(place, 0) - line
  pen.fillStyle = theme.border
  pen.fillRect(
    left,
    top,
    edgeX(place, place.columns) - left + line,
    edgeY(place, place.rows) - top + line,
  )
}
