import type { Cell } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { strokeCased, traceDiamond } from './shapes'

const GLYPHS_FROM = 14

/**
 * Start and goal: a disc and a diamond, never so small that they cannot be found, and larger under
 * the rover, so that they can be seen behind it.
 */
export function drawEnds(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { start, goal }: Pick<Problem, 'start' | 'goal'>,
  rover: Cell,
): void {
  const radius = inProportion(place, 0.46, 6.5, 30)
  const radiusAt = (cell: Cell) => (cell === rover ? 1.35 * radius : radius)
  drawGoal(pen, place, theme, goal, radiusAt(goal))
  drawStart(pen, place, theme, start, (start === goal ? 0.45 : 0.86) * radiusAt(start))
}

function drawStart(pen: Pen, place: Placement, theme: Theme, cell: Cell, radius: number) {
  const x = centreX(place, cell)
  const y = centreY(place, cell)
  pen.beginPath()
  pen.arc(x, y, radius, 0, 2 * Math.PI)
  fillAndRim(pen, place, theme, theme.start)
  if (!cellsAreAtLeast(place, GLYPHS_FROM)) return
  pen.fillStyle = theme.markGlyph
  pen.beginPath()
  pen.moveTo(x + 0.52 * radius, y)
  pen.lineTo(x - 0.28 * radius, y - 0.46 * radius)
  pen.lineTo(x - 0.28 * radius, y + 0.46 * radius)
  pen.fill()
}

function drawGoal(pen: Pen, place: Placement, theme: Theme, cell: Cell, radius: number) {
  const x = centreX(place, cell)
  const y = centreY(place, cell)
  pen.beginPath()
  traceDiamond(pen, x, y, radius)
  fillAndRim(pen, place, theme, theme.goal)
  if (!cellsAreAtLeast(place, GLYPHS_FROM)) return
  pen.fillStyle = theme.markGlyph
  pen.beginPath()
  traceDiamond(pen, x, y, 0.4 * radius)
  pen.fill()
}

function fillAndRim(pen: Pen, place: Placement, theme: Theme, fill: string): void {
  const rim = inProportion(place, 0.07, 1.5, 3)
  const { casing, markRim } = theme
  pen.lineJoin = 'round'
  strokeCased(pen, { casing, casingWidth: 2 * rim, colour: markRim, width: rim })
  pen.fillStyle = fill
  pen.fill()
}
