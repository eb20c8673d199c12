import { pathStyles, type StyledPath } from '../path-styles'
import type { Pen } from '../pen'
import { inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { traceCells } from './polyline'

/** How far the outermost paths lie from the middle of their cells, in cells. */
const REACH = 0.34

/** Paths of several planners, each in its own colour, dashes and lane. */
export function drawComparison(
  pen: Pen,
  place: Placement,
  theme: Theme,
  paths: readonly StyledPath[],
): void {
  if (paths.length === 0) return
  const width = inProportion(place, 0.09, 1.75, 4.5)
  pen.lineJoin = 'round'
  // Round ends would fill the gaps between dashes.
  pen.lineCap = 'butt'
  // All casings come first, so that none hides the line beside it.
  pen.strokeStyle = theme.casing
  pen.lineWidth = width + inProportion(place, 0.05, 1.5, 3)
  for (const styled of paths) strokeInLane(pen, place, styled)
  pen.lineWidth = width
  for (const styled of paths) {
    const { colour, dash } = styled.style
    pen.strokeStyle = colour[theme.name]
    pen.setLineDash(dash.map((length) => length * width))
    strokeInLane(pen, place, styled)
  }
  pen.setLineDash([])
}

function strokeInLane(pen: Pen, place: Placement, { path, style }: StyledPath): void {
  pen.beginPath()
  traceCells(pen, inLane(place, style.lane), path)
  pen.stroke()
}

/**
 * The map moved a little, by as much as the lane says: along a line that is parallel to no step, so
 * that lanes part in every direction.
 */
export function inLane(place: Placement, lane: number): Placement {
  const middle = (pathStyles.length - 1) / 2
  const offset = ((lane - middle) / middle) * REACH * place.cell
  return { ...place, left: place.left + 0.7 * offset, top: place.top + offset }
}
