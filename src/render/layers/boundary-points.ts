import type { Cell } from '../../grid/grid'
import type { Cells } from '../../trace/frame'
import type { Pen } from '../pen'
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

/** Hit points: full triangles that point down, numbered in their order. */
export function drawHits(pen: Pen, place: Placement, theme: Theme, cells: Cells): void {
  Array.from(cells).forEach((cell, i) => {
    if (!isVisible(place, cell)) return
    traceTriangle(pen, place, cell, 1)
    fillAndRim(pen, place, theme.hit, theme.casing)
    drawNumber(pen, place, cell, i + 1, 1, theme.casing)
  })
}

/** Leave points: hollow triangles that point up, numbered in their order. */
export function drawLeaves(pen: Pen, place: Placement, theme: Theme, cells: Cells): void {
  Array.from(cells).forEach((cell, i) => {
    if (!isVisible(place, cell)) return
    traceTriangle(pen, place, cell, -1)
    fillAndRim(pen, place, theme.casing, theme.leave)
    drawNumber(pen, place, cell, i + 1, -1, theme.leave)
  })
}

/** A triangle around the centre of a cell; `down` is 1 if it points down, -1 if up. */
function traceTriangle(pen: Pen, place: Placement, cell: Cell, down: number): void {
  const radius = inProportion(place, 0.44, 5, 22)
  const x = centreX(place, cell)
  const y = centreY(place, cell) - 0.12 * radius * down
  pen.beginPath()
  pen.moveTo(x, y + radius * down)
  pen.lineTo(x - 0.92 * radius, y - 0.62 * radius * down)
  pen.lineTo(x + 0.92 * radius, y - 0.62 * radius * down)
  pen.closePath()
}

function fillAndRim(pen: Pen, place: Placement, fill: string, rim: string): void {
  pen.lineJoin = 'round'
  pen.fillStyle = fill
  pen.fill()
  pen.strokeStyle = rim
  pen.lineWidth = inProportion(place, 0.07, 1.5, 2.5)
  pen.stroke()
}

function drawNumber(
  pen: Pen,
  place: Placement,
  cell: Cell,
  number: number,
  down: number,
  colour: string,
): void {
  if (!cellsAreAtLeast(place, NUMBERS_FROM)) return
  const size = inProportion(place, 0.34, 7, 16)
  pen.font = `bold ${size}px system-ui, sans-serif`
  pen.textAlign = 'center'
  pen.textBaseline = 'middle'
  pen.fillStyle = colour
  pen.fillText(String(number), centreX(place, cell), centreY(place, cell) - 0.22 * size * down)
}
