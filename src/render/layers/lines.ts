import type { Pen } from '../pen'
import { cellsAreAtLeast, edgeX, edgeY, type Placement } from '../placement'
import type { Theme } from '../theme'
import { LINES_FROM } from '../view'

/** The lines between cells, as thin as the screen allows, fading in with the size of the cells. */
export function drawLines(pen: Pen, place: Placement, theme: Theme): void {
  if (!cellsAreAtLeast(place, LINES_FROM)) return
  const { fromX, fromY, toX, toY } = place
  const left = edgeX(place, fromX)
  const top = edgeY(place, fromY)
  const width = edgeX(place, toX) - left
  const height = edgeY(place, toY) - top
  const line = Math.max(1, Math.round(place.pixel / 2))
  pen.beginPath()
  for (let x = Math.max(1, fromX); x < toX; x++) pen.rect(edgeX(place, x), top, line, height)
  for (let y = Math.max(1, fromY); y < toY; y++) pen.rect(left, edgeY(place, y), width, line)
  pen.fillStyle = theme.gridLine
  pen.globalAlpha = Math.min(1, place.cell / place.pixel / (3 * LINES_FROM))
  pen.fill()
  pen.globalAlpha = 1
}
