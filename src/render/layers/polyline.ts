import type { Cell } from '../../grid/grid'
import type { Pen } from '../pen'
import { centreX, centreY, mayBeSeen, type Placement } from '../placement'

/** Columns are compared too: on a map two cells wide, different steps change a cell's index alike. */
function goesStraightOn({ columns }: Placement, a: Cell, b: Cell, c: Cell): boolean {
  return b - a === c - b && (b % columns) - (a % columns) === (c % columns) - (b % columns)
}

/**
 * Adds the line through the centres of cells, each next to the one before, to the current path:
 * straight runs as one segment, and only what may be seen.
 */
export function traceCells(
  pen: Pick<Pen, 'moveTo' | 'lineTo'>,
  place: Placement,
  cells: ArrayLike<Cell>,
): void {
  let drawn = -1
  let from = 0
  for (let i = 1; i < cells.length; i++) {
    if (i + 1 < cells.length && goesStraightOn(place, cells[i - 1], cells[i], cells[i + 1]))
      continue
    if (mayBeSeen(place, cells[from], cells[i])) {
      if (drawn !== from) pen.moveTo(centreX(place, cells[from]), centreY(place, cells[from]))
      pen.lineTo(centreX(place, cells[i]), centreY(place, cells[i]))
      drawn = i
    }
    from = i
  }
}
