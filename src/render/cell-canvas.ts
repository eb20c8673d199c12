import type { Grid } from '../grid/grid'
import type { Box } from './box'
import { edgeX, edgeY, isBoxVisible, type Placement } from './placement'
import { type Tiling, tileAt, tilingOf } from './tiling'

/** The context of a canvas. @throws Error if the browser draws no canvas. */
export function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d')
  if (!context) throw new Error('This browser cannot draw on a canvas.')
  return context
}

/**
 * The cell image on canvases off the screen, from where it is drawn at any size: one for each tile,
 * because a canvas that was drawn is copied as a whole as soon as a pixel of it changes.
 */
export class CellCanvas {
  #tiling: Tiling = { columns: 0, boxes: [] }
  #tiles: readonly CanvasRenderingContext2D[] = []
  #image: ImageData | null = null

  /** Takes over the pixels in the boxes, from `pixels` with one pixel for each cell of the grid. */
  take(pixels: Uint32Array<ArrayBuffer>, grid: Grid, boxes: readonly Box[]): void {
    const { width, height } = grid
    if (this.#image?.data.buffer !== pixels.buffer || this.#image.width !== width) {
      this.#image = new ImageData(new Uint8ClampedArray(pixels.buffer), width, height)
      this.#tiling = tilingOf(grid)
      this.#tiles = this.#tiling.boxes.map(tileContext)
    }
    for (const { left, top, right, bottom } of boxes) {
      const tile = tileAt(this.#tiling, left, top)
      const { left: x, top: y } = this.#tiling.boxes[tile]
      const context = this.#tiles[tile]
      context.putImageData(this.#image, -x, -y, left, top, right - left, bottom - top)
    }
  }

  /** Draws the cells that can be seen; if `part` is a part of them, only the tiles that it touches. */
  draw(context: CanvasRenderingContext2D, place: Placement, part = place): void {
    // Cells smaller than a pixel are averaged: else thin obstacles come and go with the zoom.
    context.imageSmoothingEnabled = place.cell < 1
    context.imageSmoothingQuality = 'medium'
    this.#tiling.boxes.forEach((box, tile) => {
      if (!isBoxVisible(part, box)) return
      const fromX = Math.max(box.left, place.fromX)
      const fromY = Math.max(box.top, place.fromY)
      const columns = Math.min(box.right, place.toX) - fromX
      const rows = Math.min(box.bottom, place.toY) - fromY
      const left = edgeX(place, fromX)
      const top = edgeY(place, fromY)
      const width = edgeX(place, fromX + columns) - left
      const height = edgeY(place, fromY + rows) - top
      const { canvas } = this.#tiles[tile]
      const [x, y] = [fromX - box.left, fromY - box.top]
      context.drawImage(canvas, x, y, columns, rows, left, top, width, height)
    })
  }
}

function tileContext({ left, top, right, bottom }: Box): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas')
  canvas.width = right - left
  canvas.height = bottom - top
  return contextOf(canvas)
}
