import type { Cell } from '../../grid/grid'
import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, edgeX, edgeY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceTurned } from './turned'

/** The square that the rover senses, as far as it lies on the map. */
export function drawSensedSquare(
  pen: Pen,
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
  pen.fillStyle = theme.sensorArea
  pen.fillRect(left, top, width, height)
  pen.strokeStyle = theme.sensor
  pen.lineWidth = line
  pen.strokeRect(left + line / 2, top + line / 2, width - line, height - line)
}

/** The rover, or the agent in a potential field: an arrow head in the direction of `angle`. */
export function drawRover(
  pen: Pen,
  place: Placement,
  theme: Theme,
  rover: Cell,
  angle: number,
): void {
  const size = inProportion(place, 0.36, 5.5, 24)
  const points = [
    [size, 0],
    [-0.75 * size, 0.75 * size],
    [-0.35 * size, 0],
    [-0.75 * size, -0.75 * size],
  ] as const
  pen.beginPath()
  traceTurned(pen, centreX(place, rover), centreY(place, rover), angle, points)
  pen.closePath()
  pen.lineJoin = 'round'
  pen.strokeStyle = theme.casing
  pen.lineWidth = inProportion(place, 0.1, 2.5, 5)
  pen.stroke()
  pen.fillStyle = theme.rover
  pen.fill()
}

/** Where the trail leads, as an angle clockwise from east; towards the goal while it has not begun. */
export function headingOf(columns: number, trail: Cells, goal: Cell): number {
  const moved = trail.length > 1
  const to = moved ? trail[trail.length - 1] : goal
  const from = moved ? trail[trail.length - 2] : (trail[0] ?? goal)
  return Math.atan2(
    Math.floor(to / columns) - Math.floor(from / columns),
    (to % columns) - (from % columns),
  )
}
