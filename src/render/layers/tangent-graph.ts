import type { Cell } from '../../grid/grid'
import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { strokeCased, traceDiamond } from './shapes'

/** The local tangent graph: diamonds for its nodes, each joined to the rover by a thin line. */
export function drawTangentGraph(
  pen: Pen,
  place: Placement,
  theme: Theme,
  rover: Cell,
  nodes: Cells,
): void {
  const line = inProportion(place, 0.035, 0.75, 1.5)
  const inMap = Array.from(nodes).filter((node) => node >= 0)
  pen.lineCap = 'butt'
  pen.lineJoin = 'miter'
  pen.beginPath()
  for (const node of inMap) {
    pen.moveTo(centreX(place, rover), centreY(place, rover))
    pen.lineTo(centreX(place, node), centreY(place, node))
  }
  const { casing, sensor } = theme
  strokeCased(pen, { casing, casingWidth: 3 * line, colour: sensor, width: line })

  const radius = inProportion(place, 0.2, 3, 8)
  pen.beginPath()
  for (const node of inMap) {
    traceDiamond(pen, centreX(place, node), centreY(place, node), radius)
  }
  pen.strokeStyle = casing
  pen.lineWidth = 4 * line
  pen.stroke()
  pen.fillStyle = sensor
  pen.fill()
}
