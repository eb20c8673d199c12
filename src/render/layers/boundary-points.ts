import type { Cell } from '../../grid/grid'
import {
  cellsAreAtLeast,
  centreX,
  centreY,
  inProportion,
  isVisible,
  type Placement,
} from '../placement'
import type { Theme } from '../theme'

const NUMBERS_FROM = 22

type Context = CanvasRenderingContext2D

/** Hit points: full triangles that point down, numbered in their order. */
export function drawHits(
  context: Context,
  place: Placement,
  theme: Theme,
  cells: readonly Cell[],
): void {
  cells.forEach((cell, i) => {
    if (!isVisible(place, cell)) return
    traceTriangle(context, place, cell, 1)
    fillAndRim(context, place, theme.hit, theme.casing)
    drawNumber(context, place, cell, i + 1, 1, theme.casing)
  })
}

/** Leave points: hollow triangles that point up, numbered in their order. */
export function drawLeaves(
  context: Context,
  place: Placement,
  theme: Theme,
  cells: readonly Cell[],
): void {
  cells.forEach((cell, i) => {
    if (!isVisible(place, cell)) return
    traceTriangle(context, place, cell, -1)
    fillAndRim(context, place, theme.casing, theme.leave)
    drawNumber(context, place, cell, i + 1, -1, theme.leave)
  })
}

/** A triangle around the centre of a cell; `down` is 1 if it points down, -1 if up. */
function traceTriangle(context: Context, place: Placement, cell: Cell, down: number): void {
  const radius = inProportion(place, 0.44, 5, 22)
  const x = centreX(place, cell)
  const y = centreY(place, cell) - 0.12 * radius * down
  context.beginPath()
  context.moveTo(x, y + radius * down)
  context.lineTo(x - 0.92 * radius, y - 0.62 * radius * down)
  context.lineTo(x + 0.92 * radius, y - 0.62 * radius * down)
  context.closePath()
}

function fillAndRim(context: Context, place: Placement, fill: string, rim: string): void {
  context.lineJoin = 'round'
  context.fillStyle = fill
  context.fill()
  context.strokeStyle = rim
  context.lineWidth = inProportion(place, 0.07, 1.5, 2.5)
  context.stroke()
}

function drawNumber(
  context: Context,
  place: Placement,
  cell: Cell,
  number: number,
  down: number,
  colour: string,
): void {
  if (!cellsAreAtLeast(place, NUMBERS_FROM)) return
  const size = inProportion(place, 0.34, 7, 16)
  context.font = `bold ${size}px Roboto, system-ui, sans-serif`
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  context.fillStyle = colour
  context.fillText(String(number), centreX(place, cell), centreY(place, cell) - 0.22 * size * down)
}
