import { edgeX, edgeY, type Placement } from '../placement'
import type { Theme } from '../theme'

/** The cells from an image with one pixel a cell, and a line around the map. */
export function drawCells(
  context: CanvasRenderingContext2D,
  place: Placement,
  theme: Theme,
  image: HTMLCanvasElement,
): void {
  const { fromX, fromY, toX, toY } = place
  drawBorder(context, place, theme)
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

function drawBorder(context: CanvasRenderingContext2D, place: Placement, theme: Theme): void {
  const line = Math.max(1, Math.round(place.pixel))
  const left = edgeX(place, 0) - line
  const top = edgeY(place, 0) - line
  context.fillStyle = theme.border
  context.fillRect(
    left,
    top,
    edgeX(place, place.columns) - left + line,
    edgeY(place, place.rows) - top + line,
  )
}
