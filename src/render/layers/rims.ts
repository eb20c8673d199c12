import { DX, DY, isDiagonal } from '../../grid/directions'
import type { Cell, Grid } from '../../grid/grid'
import { obstaclesAround } from '../../grid/steps'
import type { Pen } from '../pen'
import { cellsAreAtLeast, edgeX, edgeY, inProportion, type Placement } from '../placement'

const RIMS_FROM = 10
const ALL_AROUND = 0xff

/** A rim inside the obstacles, along their outline, in the colour that is given for each cell. */
export function drawRims(
  pen: Pen,
  place: Placement,
  grid: Grid,
  colourOf: (cell: Cell) => string,
): void {
  if (!cellsAreAtLeast(place, RIMS_FROM)) return
  const rim = Math.round(inProportion(place, 0.06, 1, 2.5))
  for (let y = place.fromY; y < place.toY; y++) {
    for (let x = place.fromX; x < place.toX; x++) {
      const cell = y * grid.width + x
      if (grid.walls[cell] === 0) continue
      const obstacles = obstaclesAround(grid, cell)
      if (obstacles === ALL_AROUND) continue
      pen.fillStyle = colourOf(cell)
      for (let d = 0; d < 8; d++) if (hasRim(obstacles, d)) drawRim(pen, place, x, y, d, rim)
    }
  }
}

/** A free neighbour makes a rim; at a corner only if the sides next to it do not reach it. */
function hasRim(obstacles: number, d: number): boolean {
  const isFree = (direction: number) => ((obstacles >> (direction & 7)) & 1) === 0
  return isFree(d) && !(isDiagonal(d) && (isFree(d - 1) || isFree(d + 1)))
}

function drawRim(pen: Pen, place: Placement, x: number, y: number, d: number, rim: number): void {
  const left = DX[d] > 0 ? edgeX(place, x + 1) - rim : edgeX(place, x)
  const top = DY[d] > 0 ? edgeY(place, y + 1) - rim : edgeY(place, y)
  const width = DX[d] === 0 ? edgeX(place, x + 1) - left : rim
  const height = DY[d] === 0 ? edgeY(place, y + 1) - top : rim
  pen.fillRect(left, top, width, height)
}
