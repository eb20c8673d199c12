import type { Cell } from '../../grid/grid'
import type { Pen } from '../pen'
import type { Placement } from '../placement'
import type { Theme } from '../theme'
import { boxAround, inset, strokeBox } from './boxes'

const LEAST_CURSOR = 12
const LEAST_HOVERED = 8

/** The keyboard's cell: a frame of two lines, one of which stands out on any cell. */
export function drawCursor(pen: Pen, place: Placement, theme: Theme, cell: Cell): void {
  const line = Math.round(2 * place.pixel)
  const box = boxAround(place, cell, cell, LEAST_CURSOR * place.pixel)
  strokeBox(pen, inset(box, -line / 2), line, theme.casing, theme.cursor)
}

/** The cell that is asked about: the same, but thinner and within the cell. */
export function drawHovered(pen: Pen, place: Placement, theme: Theme, cell: Cell): void {
  const line = Math.max(1, Math.round(place.pixel))
  const box = boxAround(place, cell, cell, LEAST_HOVERED * place.pixel)
  strokeBox(pen, inset(box, 1.5 * line), line, theme.casing, theme.cursor)
}
