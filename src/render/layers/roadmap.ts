import type { Cell } from '../../grid/grid'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, isVisible, type Placement } from '../placement'
import type { Theme } from '../theme'
import { mayBeSeen } from './polyline'

/** @param lines pairs of cells, one after the other */
export function drawEdges(pen: Pen, place: Placement, theme: Theme, lines: readonly Cell[]): void {
  pen.lineCap = 'round'
  pen.strokeStyle = theme.roadmap
  pen.lineWidth = inProportion(place, 0.05, 0.8, 2)
  pen.beginPath()
  for (let i = 0; i + 1 < lines.length; i += 2) {
    if (!mayBeSeen(place, lines[i], lines[i + 1])) continue
    pen.moveTo(centreX(place, lines[i]), centreY(place, lines[i]))
    pen.lineTo(centreX(place, lines[i + 1]), centreY(place, lines[i + 1]))
  }
  pen.stroke()
}

export function drawVertices(
  pen: Pen,
  place: Placement,
  theme: Theme,
  vertices: readonly Cell[],
): void {
  const radius = inProportion(place, 0.14, 1.5, 5)
  pen.fillStyle = theme.vertex
  pen.beginPath()
  for (const cell of vertices) {
    if (!isVisible(place, cell)) continue
    const x = centreX(place, cell)
    const y = centreY(place, cell)
    pen.moveTo(x + radius, y)
    pen.arc(x, y, radius, 0, 2 * Math.PI)
  }
  pen.fill()
}
