import type { Grid } from '../grid/grid'
import type { Box } from './box'
import { edgeX, edgeY, isBoxVisible, type Placement } from './placement'
import { TileCanvas } from './tile-canvas'
import { type Tiling, tileAt, tilingOf } from './tiling'

/**
 * The cell image on canvases off the screen, from where it is drawn at any size: one for each tile,
 * because a canvas that was drawn is copied as a whole as soon as a pixel of it changes.
 */
export class CellCanvas {
  #tiling: Tiling = { columns: 0, boxes: [] }
  /** There is none for a tile as long as nothing of it is painted. */
  #tiles: TileCanvas[] = []
  #image: ImageData | null = null

  /** Takes over the pixels in the boxes, from `pixels` with one pixel for each cell of the grid. */
  take(pixels: Uint32Array<ArrayBuffer>, grid: Grid, boxes: readonly Box[]): void {
    const { width, height } = grid
    if (this.#image?.data.buffer !== pixels.buffer || this.#image.width !== width) {
      this.#image = new ImageData(new Uint8ClampedArray(pixels.buffer), width, height)
      this.#tiling = tilingOf(grid)
      this.#tiles = []
    }
    for (const box of boxes) {
      const tile = tileAt(this.#tiling, box.left, box.top)
      const whole = this.#tiling.boxes[tile]
      this.#tiles[tile] ??= new TileCanvas(whole)
      this.#tiles[tile].take(this.#image, whole.left, whole.top, box)
    }
  }

  /** Draws the cells that can be seen; if `part` is a part of them, only the tiles that it touches. */
  draw(context: CanvasRenderingContext2D, place: Placement, part = place): void {
    // Cells smaller than a pixel are averaged: else thin obstacles come and go with the zoom.
    context.imageSmoothingEnabled = place.cell < 1
    this.#tiles.forEach((canvas, tile) => {
      const box = this.#tiling.boxes[tile]
      if (!isBoxVisible(part, box)) return
      const image = canvas.imageFor(place.cell)
      const fromX = Math.max(box.left, place.fromX)
      const fromY = Math.max(box.top, place.fromY)
      const toX = Math.min(box.right, place.toX)
      const toY = Math.min(box.bottom, place.toY)
      const left = edgeX(place, fromX)
      const top = edgeY(place, fromY)
      // Pixels of the image in a cell, on each side.
      const across = image.width / (box.right - box.left)
      const down = image.height / (box.bottom - box.top)
      context.drawImage(
        image,
        (fromX - box.left) * across,
        (fromY - box.top) * down,
        (toX - fromX) * across,
        (toY - fromY) * down,
        left,
        top,
        edgeX(place, toX) - left,
        edgeY(place, toY) - top,
      )
    })
  }
}
