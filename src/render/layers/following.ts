import type { Cell } from '../../grid/grid'
import type { Frame } from '../../trace/frame'
import type { Pen } from '../pen'
import { centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { boxAround, inset, strokeBox } from './boxes'
import { strokeCased } from './shapes'
import { traceTurned } from './turned'

const LEAST_BOX = 9

/** The obstacle cell that the rover keeps at its side: framed, which those felt before are not. */
export function drawAtSide(pen: Pen, place: Placement, theme: Theme, cell: Cell): void {
  const line = inProportion(place, 0.09, 1.5, 3.5)
  const box = boxAround(place, cell, cell, LEAST_BOX * place.pixel)
  strokeBox(pen, inset(box, 1.5 * line), line, theme.casing, theme.hit)
}

/**
 * A rail beside the rover, on the side where the obstacle is, with an arrow head where the way round
 * the obstacle leads.
 */
export function drawRail(
  pen: Pen,
  place: Placement,
  theme: Theme,
  rover: Cell,
  angle: number,
  turn: number,
): void {
  const size = inProportion(place, 0.36, 5.5, 24)
  const side = turn === 0 ? -1 : 1
  const beside = 1.15 * size * side
  const points = [
    [-1.1 * size, beside],
    [1.25 * size, beside],
    [0.65 * size, beside - 0.55 * size * side],
  ] as const
  pen.beginPath()
  traceTurned(pen, centreX(place, rover), centreY(place, rover), angle, points)
  pen.lineJoin = 'round'
  pen.lineCap = 'round'
  const line = inProportion(place, 0.09, 1.75, 4.5)
  const { casing, hit } = theme
  strokeCased(pen, { casing, casingWidth: 2 * line, colour: hit, width: line })
}

/**
 * Where the way round the obstacle leads, as an angle clockwise from east: square to the obstacle
 * cell at the rover's side; `heading` if that is the border of the map.
 */
export function railAngle(columns: number, frame: Frame, heading: number): number {
  const { rover, atSide, turn } = frame
  if (atSide < 0) return heading
  const dx = (atSide % columns) - (rover % columns)
  const dy = Math.floor(atSide / columns) - Math.floor(rover / columns)
  return Math.atan2(dy, dx) + (turn === 0 ? Math.PI / 2 : -Math.PI / 2)
}
