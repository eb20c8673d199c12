import type { Grid } from '../../grid/grid'
import { type Frame, isFelt } from '../../trace/frame'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCircle } from './shapes'

const DOTS_FROM = 10

/** A dot on each obstacle cell that the rover has felt, so that not only its colour is different. */
export function drawFelt(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { walls, width }: Grid,
  frame: Frame,
): void {
  if (!cellsAreAtLeast(place, DOTS_FROM)) return
  const radius = 0.11 * place.cell
  pen.fillStyle = theme.feltMark
  pen.beginPath()
  for (let y = place.fromY; y < place.toY; y++) {
    for (let x = place.fromX; x < place.toX; x++) {
      const cell = y * width + x
      if (!walls[cell] || !isFelt(frame, cell)) continue
      traceCircle(pen, centreX(place, cell), centreY(place, cell), radius)
    }
  }
  pen.fill()
}
