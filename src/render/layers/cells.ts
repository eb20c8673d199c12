import type { Pen } from '../pen'
import { edgeX, edgeY, type Placement } from '../placement'
import type { Theme } from '../theme'

/** The cells from an image with one pixel a cell. */
export function drawCells(
  context: CanvasRenderingContext2D,
  place: Placement,
  image: HTMLCanvasElement,
): void {
  const { fromX, fromY, toX, toY } = place
  if (toX <= fromX || toY <= fromY) return
  const left = edgeX(place, fromX)
  const top = edgeY(place, fromY)
  const width = edgeX(place, toX) - left
  const height = edgeY(place, toY) - top
  // Cells smaller than a pixel are averaged: else thin obstacles come and go with the zoom.
  context.imageSmoothingEnabled = place.cell < 1
  context.imageSmoothingQuality = 'medium'
  context.drawImage(image, fromX, fromY, toX - fromX, toY - fromY, left, top, width, height)
}

/** A line around the map, drawn as what the cells leave of a larger rectangle. */
export function drawBorder(pen: Pen, place: Placement, theme: Theme): void {
  const line = Math.max(1, Math.round(place.pixel))
  const left = edgeX(place, 0) - line
  const top = edgeY(place, 0) - line
  pen.fillStyle = theme.border
  pen.fillRect(
    left,
    top,
    edgeX(place, place.columns) - left + line,
    edgeY(place, place.rows) - top + line,
  )
}
