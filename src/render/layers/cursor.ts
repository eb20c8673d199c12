import type { Cell } from '../../grid/grid'
import { edgeX, edgeY, type Placement } from '../placement'
import type { Theme } from '../theme'

const LEAST_SIDE = 12

/** The keyboard's cell: a frame of two lines, one of which stands out on any cell. */
export function drawCursor(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  cell: Cell,
): void {
  const x = cell % place.columns
  const y = Math.floor(cell / place.columns)
  const line = Math.round(2 * place.pixel)
  const side = Math.max(edgeX(place, x + 1) - edgeX(place, x), LEAST_SIDE * place.pixel)
  const left = Math.round((edgeX(place, x) + edgeX(place, x + 1) - side) / 2)
  const top = Math.round((edgeY(place, y) + edgeY(place, y + 1) - side) / 2)
  const frame = (colour: string, width: number) => {
    context.strokeStyle = colour
    context.lineWidth = width
    context.strokeRect(left - line / 2, top - line / 2, side + line, side + line)
  }
  context.lineJoin = 'round'
  frame(theme.casing, 3 * line)
  frame(theme.cursor, line)
}
