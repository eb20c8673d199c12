import type { Cell } from '../../grid/grid'
import { centreX, centreY, inProportion, isVisible, type Placement } from '../placement'
import type { Theme } from '../theme'
import { mayBeSeen } from './polyline'

/** The edges from number `first` on, each as the simplest path that it stands for. */
export function drawEdges(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  edges: readonly Cell[],
  first: number,
): void {
  context.lineJoin = 'round'
  context.strokeStyle = theme.roadmap
  context.lineWidth = inProportion(place, 0.05, 0.8, 2)
  context.beginPath()
  for (let i = 2 * first; i + 1 < edges.length; i += 2) {
    if (mayBeSeen(place, edges[i], edges[i + 1])) traceEdge(context, place, edges[i], edges[i + 1])
  }
  context.stroke()
}

/** Diagonally while both axes differ, then straight. */
function traceEdge(
  context: CanvasRenderingContext2D,
  place: Placement,
  from: Cell,
  to: Cell,
): void {
  const x = centreX(place, from)
  const y = centreY(place, from)
  const endX = centreX(place, to)
  const endY = centreY(place, to)
  const diagonal = Math.min(Math.abs(endX - x), Math.abs(endY - y))
  context.moveTo(x, y)
  context.lineTo(x + Math.sign(endX - x) * diagonal, y + Math.sign(endY - y) * diagonal)
  context.lineTo(endX, endY)
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
