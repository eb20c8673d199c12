import type { Cell } from '../../grid/grid'
import { centreX, centreY, inProportion, isVisible, type Placement } from '../placement'
import type { Theme } from '../theme'
import { mayBeSeen } from './polyline'

/** @param lines pairs of cells, one after the other */
export function drawEdges(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  lines: readonly Cell[],
): void {
  context.lineCap = 'round'
  context.strokeStyle = theme.roadmap
  context.lineWidth = inProportion(place, 0.05, 0.8, 2)
  context.beginPath()
  for (let i = 0; i + 1 < lines.length; i += 2) {
    if (!mayBeSeen(place, lines[i], lines[i + 1])) continue
    context.moveTo(centreX(place, lines[i]), centreY(place, lines[i]))
    context.lineTo(centreX(place, lines[i + 1]), centreY(place, lines[i + 1]))
  }
  context.stroke()
}

export function drawVertices(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  vertices: readonly Cell[],
): void {
  const radius = inProportion(place, 0.14, 1.5, 5)
  context.fillStyle = theme.vertex
  context.beginPath()
  for (const cell of vertices) {
    if (!isVisible(place, cell)) continue
    const x = centreX(place, cell)
    const y = centreY(place, cell)
    context.moveTo(x + radius, y)
    context.arc(x, y, radius, 0, 2 * Math.PI)
  }
  context.fill()
}
