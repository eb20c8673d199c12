import type { Grid } from '../../grid/grid'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCircle } from './shapes'

/** Smaller cells have no room for a dot. */
export const DOTS_FROM = 4

/** A dot in each free cell of the first `rows` rows: these are vertices of the grid's graph. */
export function drawRowDots(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { walls, width }: Grid,
  rows: number,
): void {
  if (rows === 0 || !cellsAreAtLeast(place, DOTS_FROM)) return
  const radius = inProportion(place, 0.09, 0.75, 4)
  pen.fillStyle = theme.vertex
  pen.beginPath()
  for (let y = place.fromY; y < Math.min(rows, place.toY); y++) {
    for (let x = place.fromX; x < place.toX; x++) {
      const cell = y * width + x
      if (walls[cell]) continue
      traceCircle(pen, centreX(place, cell), centreY(place, cell), radius)
    }
  }
  pen.fill()
}
