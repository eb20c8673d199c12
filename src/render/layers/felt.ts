import type { Grid } from '../../grid/grid'
import { type Frame, isFelt } from '../../trace/frame'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, type Placement } from '../placement'
import type { Theme } from '../theme'

const DOTS_FROM = 10

/** A dot on each obstacle cell that the rover has felt: told from the others without its colour. */
export function drawFelt(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { walls, width }: Grid,
  frame: Frame,
): void {
  if (!cellsAreAtLeast(place, DOTS_FROM)) return
  pen.fillStyle = theme.feltMark
  pen.beginPath()
  for (let y = place.fromY; y < place.toY; y++) {
    for (let x = place.fromX; x < place.toX; x++) {
      const cell = y * width + x
      if (!walls[cell] || !isFelt(frame, cell)) continue
      const radius = 0.11 * place.cell
      pen.moveTo(centreX(place, cell) + radius, centreY(place, cell))
      pen.arc(centreX(place, cell), centreY(place, cell), radius, 0, 2 * Math.PI)
    }
  }
  pen.fill()
}
