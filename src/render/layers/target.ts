import type { Cell } from '../../grid/grid'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'

/** Where the rover is heading: a ring, and a dotted line to it. */
export function drawTarget(
  pen: Pen,
  place: Placement,
  theme: Theme,
  rover: Cell,
  target: Cell,
): void {
  const x = centreX(place, target)
  const y = centreY(place, target)
  const line = inProportion(place, 0.07, 1.25, 2.5)
  pen.strokeStyle = theme.sensor
  pen.lineWidth = line
  pen.lineCap = 'round'
  pen.setLineDash([0, 3 * line])
  pen.beginPath()
  pen.moveTo(centreX(place, rover), centreY(place, rover))
  pen.lineTo(x, y)
  pen.stroke()
  pen.setLineDash([])
  pen.beginPath()
  pen.arc(x, y, inProportion(place, 0.3, 4, 18), 0, 2 * Math.PI)
  pen.stroke()
}
