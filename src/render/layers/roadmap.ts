import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCircle } from './shapes'

/** @param lines pairs of cells, one after the other, of those that may be seen */
export function drawEdges(pen: Pen, place: Placement, theme: Theme, lines: Cells): void {
  pen.lineCap = 'round'
  pen.strokeStyle = theme.roadmap
  pen.lineWidth = inProportion(place, 0.05, 0.8, 2)
  pen.beginPath()
  for (let i = 0; i + 1 < lines.length; i += 2) {
    pen.moveTo(centreX(place, lines[i]), centreY(place, lines[i]))
    pen.lineTo(centreX(place, lines[i + 1]), centreY(place, lines[i + 1]))
  }
  pen.stroke()
}

/** More circles than this take too long for a frame. Where there are so many, they are too small to be told from squares. */
const MOST_CIRCLES = 4000

/** @param vertices those that may be seen */
export function drawVertices(pen: Pen, place: Placement, theme: Theme, vertices: Cells): void {
  const radius = inProportion(place, 0.14, 1.5, 5)
  const areSquares = vertices.length > MOST_CIRCLES
  const side = Math.round(2 * radius)
  pen.fillStyle = theme.vertex
  pen.beginPath()
  for (const cell of vertices) {
    const x = centreX(place, cell)
    const y = centreY(place, cell)
    // Squares on whole pixels are filled much faster.
    if (areSquares) pen.rect(Math.round(x - radius), Math.round(y - radius), side, side)
    else traceCircle(pen, x, y, radius)
  }
  pen.fill()
}
