import type { Cell } from '../../grid/grid'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'

/** Where the rover is heading: a ring, and a dotted line to it. */
export function drawTarget(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  rover: Cell,
  target: Cell,
): void {
  const x = centreX(place, target)
  const y = centreY(place, target)
  const line = inProportion(place, 0.07, 1.25, 2.5)
  context.strokeStyle = theme.sensor
  context.lineWidth = line
  context.lineCap = 'round'
  context.setLineDash([0, 3 * line])
  context.beginPath()
  context.moveTo(centreX(place, rover), centreY(place, rover))
  context.lineTo(x, y)
  context.stroke()
  context.setLineDash([])
  context.beginPath()
  context.arc(x, y, inProportion(place, 0.3, 4, 18), 0, 2 * Math.PI)
  context.stroke()
}
