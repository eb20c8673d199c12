import type { Cell } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { cellsAreAtLeast, centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'

const GLYPHS_FROM = 14

type Context = CanvasRenderingContext2D

/**
 * Start and goal: a disc and a diamond, never so small that they cannot be found, and larger under
 * the rover, so that they can be seen behind it.
 */
export function drawEnds(
  context: Context,
  place: Placement,
  theme: Theme,
  { start, goal }: Pick<Problem, 'start' | 'goal'>,
  rover: Cell,
): void {
  const radius = inProportion(place, 0.46, 6.5, 30)
  const radiusAt = (cell: Cell) => (cell === rover ? 1.35 * radius : radius)
  drawGoal(context, place, theme, goal, radiusAt(goal))
  drawStart(context, place, theme, start, (start === goal ? 0.45 : 0.86) * radiusAt(start))
}

function drawStart(context: Context, place: Placement, theme: Theme, cell: Cell, radius: number) {
  const x = centreX(place, cell)
  const y = centreY(place, cell)
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
  fillAndRim(context, place, theme, theme.start)
  if (!cellsAreAtLeast(place, GLYPHS_FROM)) return
  context.fillStyle = theme.markGlyph
  context.beginPath()
  context.moveTo(x + 0.52 * radius, y)
  context.lineTo(x - 0.28 * radius, y - 0.46 * radius)
  context.lineTo(x - 0.28 * radius, y + 0.46 * radius)
  context.fill()
}

function drawGoal(context: Context, place: Placement, theme: Theme, cell: Cell, radius: number) {
  const x = centreX(place, cell)
  const y = centreY(place, cell)
  traceDiamond(context, x, y, radius)
  fillAndRim(context, place, theme, theme.goal)
  if (!cellsAreAtLeast(place, GLYPHS_FROM)) return
  context.fillStyle = theme.markGlyph
  traceDiamond(context, x, y, 0.4 * radius)
  context.fill()
}

function traceDiamond(context: Context, x: number, y: number, radius: number): void {
  context.beginPath()
  context.moveTo(x, y - radius)
  context.lineTo(x + radius, y)
  context.lineTo(x, y + radius)
  context.lineTo(x - radius, y)
  context.closePath()
}

function fillAndRim(context: Context, place: Placement, theme: Theme, fill: string): void {
  const rim = inProportion(place, 0.07, 1.5, 3)
  context.lineJoin = 'round'
  context.strokeStyle = theme.casing
  context.lineWidth = 2 * rim
  context.stroke()
  context.strokeStyle = theme.markRim
  context.lineWidth = rim
  context.stroke()
  context.fillStyle = fill
  context.fill()
}
