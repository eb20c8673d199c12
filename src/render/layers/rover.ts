import type { Cell } from '../../grid/grid'
import { centreX, centreY, edgeX, edgeY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'

type Context = CanvasRenderingContext2D

/** The square that the rover senses, as far as it lies on the map. */
export function drawSensedSquare(
  context: Context,
  place: Placement,
  theme: Theme,
  rover: Cell,
  range: number,
): void {
  const x = rover % place.columns
  const y = Math.floor(rover / place.columns)
  const left = edgeX(place, Math.max(0, x - range))
  const top = edgeY(place, Math.max(0, y - range))
  const width = edgeX(place, Math.min(place.columns, x + range + 1)) - left
  const height = edgeY(place, Math.min(place.rows, y + range + 1)) - top
  const line = Math.round(inProportion(place, 0.06, 1, 2))
  context.fillStyle = theme.sensorArea
  context.fillRect(left, top, width, height)
  context.strokeStyle = theme.sensor
  context.lineWidth = line
  context.strokeRect(left + line / 2, top + line / 2, width - line, height - line)
}

/** The rover, or the agent in a potential field: an arrow head in the direction of `angle`. */
export function drawRover(
  context: Context,
  place: Placement,
  theme: Theme,
  rover: Cell,
  angle: number,
): void {
  const size = inProportion(place, 0.36, 5.5, 24)
  context.save()
  context.translate(centreX(place, rover), centreY(place, rover))
  context.rotate(angle)
  context.beginPath()
  context.moveTo(size, 0)
  context.lineTo(-0.75 * size, 0.75 * size)
  context.lineTo(-0.35 * size, 0)
  context.lineTo(-0.75 * size, -0.75 * size)
  context.closePath()
  context.lineJoin = 'round'
  context.strokeStyle = theme.casing
  context.lineWidth = inProportion(place, 0.1, 2.5, 5)
  context.stroke()
  context.fillStyle = theme.rover
  context.fill()
  context.restore()
}

/** Where the trail leads, as an angle clockwise from east; towards the goal while it has not begun. */
export function headingOf(columns: number, trail: readonly Cell[], goal: Cell): number {
  const moved = trail.length > 1
  const to = moved ? trail[trail.length - 1] : goal
  const from = moved ? trail[trail.length - 2] : (trail[0] ?? goal)
  return Math.atan2(
    Math.floor(to / columns) - Math.floor(from / columns),
    (to % columns) - (from % columns),
  )
}
