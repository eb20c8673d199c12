import type { Grid } from '../../grid/grid'
import { type FieldRange, heatInks, heatLevel } from '../heat'
import type { Pen } from '../pen'
import { cellsAreAtLeast, centreX, centreY, inProportion, type Placement } from '../placement'
import { potentialLabel } from '../potential-label'
import type { Theme } from '../theme'

const NUMBERS_FROM = 26

/** The values of a field of potentials as numbers in its free cells, where cells are large enough to hold it. */
export function drawPotentials(
  pen: Pen,
  place: Placement,
  theme: Theme,
  { walls, width }: Grid,
  field: Float64Array,
  range: FieldRange,
): void {
  if (!cellsAreAtLeast(place, NUMBERS_FROM)) return
  const inks = heatInks(theme)
  pen.font = `${inProportion(place, 0.32, 8, 15)}px system-ui, sans-serif`
  pen.textAlign = 'center'
  pen.textBaseline = 'middle'
  for (let y = place.fromY; y < place.toY; y++) {
    for (let x = place.fromX; x < place.toX; x++) {
      const cell = y * width + x
      const level = heatLevel(range, field[cell])
      if (level < 0 || walls[cell]) continue
      pen.fillStyle = inks[level]
      pen.fillText(potentialLabel(field[cell]), centreX(place, cell), centreY(place, cell))
    }
  }
}
