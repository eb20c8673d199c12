import type { Cell, Grid } from '../../grid/grid'
import type { Test } from '../../trace/frame'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, inProportion, type Placement } from '../placement'
import type { Theme } from '../theme'
import { boxAround, inset, strokeBox } from './boxes'
import { drawCross, drawTick } from './signs'

const CELLS_FROM = 10
const LEAST_BOX = 14

/**
 * The test whether a cell is the corner of an obstacle: a tick or a cross in each of the three cells
 * that must be free, the obstacle outlined, and around all of them what came out, as a closed line
 * or a dashed one.
 */
export function drawCornerTest(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { walls, width }: Grid,
  { cell, obstacle, passed }: Test,
): void {
  const line = inProportion(place, 0.08, 1.5, 3)
  if (cellsAreAtLeast(place, CELLS_FROM)) {
    const own = boxAround(place, obstacle, obstacle, 0)
    strokeBox(pen, inset(own, 2.5 * line), line, theme.casing, theme.vertex)
    for (const tested of testedCells(width, cell, obstacle)) {
      const draw = walls[tested] ? drawCross : drawTick
      draw(pen, place, theme, centreX(place, tested), centreY(place, tested), 0.26 * place.cell)
    }
  }
  const dash = inProportion(place, 0.22, 3, 8)
  pen.lineCap = 'butt'
  pen.setLineDash(passed ? [] : [dash, 0.8 * dash])
  const around = boxAround(place, cell, obstacle, LEAST_BOX * place.pixel)
  strokeBox(pen, around, line, theme.casing, passed ? theme.passed : theme.failed)
  pen.setLineDash([])
}

/** The cell diagonal to the obstacle, and the two cells that touch both. */
export function testedCells(columns: number, cell: Cell, obstacle: Cell): Cell[] {
  const [x, obstacleX] = [cell % columns, obstacle % columns]
  return [cell, cell - x + obstacleX, obstacle - obstacleX + x]
}
