import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import {
  centreX,
  centreY,
  edgeX,
  edgeY,
  inProportion,
  isVisible,
  type Placement,
} from '../placement'
import type { Theme } from '../theme'
import { mayBeSeen } from './polyline'

/** @param lines pairs of cells, one after the other */
export function drawEdges(pen: Pen, place: Placement, theme: Theme, lines: Cells): void {
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

/** Of more vertices than this, those that would cover each other are drawn once. */
const CROWD = 10_000

export function drawVertices(pen: Pen, place: Placement, theme: Theme, vertices: Cells): void {
  const radius = inProportion(place, 0.14, 1.5, 5)
  pen.fillStyle = theme.vertex
  pen.beginPath()
  if (vertices.length > CROWD) {
    traceCrowd(pen, place, vertices, Math.ceil(radius))
    pen.fill()
    return
  }
  for (const cell of vertices) {
    if (!isVisible(place, cell)) continue
    const x = centreX(place, cell)
    const y = centreY(place, cell)
    pen.moveTo(x + radius, y)
    pen.arc(x, y, radius, 0, 2 * Math.PI)
  }
  pen.fill()
}

/** Squares in a raster, each of which a vertex falls into. */
function traceCrowd(pen: Pen, place: Placement, vertices: Cells, side: number): void {
  const left = edgeX(place, place.fromX)
  const top = edgeY(place, place.fromY)
  const columns = Math.ceil((edgeX(place, place.toX) - left) / side) + 1
  const rows = Math.ceil((edgeY(place, place.toY) - top) / side) + 1
  const isTaken = new Uint8Array(columns * rows)
  for (const cell of vertices) {
    if (!isVisible(place, cell)) continue
    const column = Math.floor((centreX(place, cell) - left) / side)
    const row = Math.floor((centreY(place, cell) - top) / side)
    if (column < 0 || row < 0 || column >= columns || row >= rows) continue
    if (isTaken[row * columns + column]) continue
    isTaken[row * columns + column] = 1
    pen.rect(left + column * side, top + row * side, side, side)
  }
}
