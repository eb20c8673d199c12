import type { Box } from './box'
import { newContext } from './canvas'

/** Below this size of a cell, in device pixels, a tile is drawn from its half. */
const HALF_BELOW = 0.5

/**
 * The cells of one tile as an image, one pixel each, and the same at half the size, at half of that,
 * and so on, as far as that is asked for: a map as a whole is drawn from fewer pixels, and each of them
 * counts. Browsers leave out pixels of an image that they draw at less than half its size, some of them
 * however they are asked to smooth it.
 */
export class TileCanvas {
  readonly #full: CanvasRenderingContext2D
  readonly #halves: CanvasRenderingContext2D[] = []
  /** How many of the halves show the cells as they are. */
  #inTime = 0

  constructor({ left, top, right, bottom }: Box) {
    this.#full = newContext(right - left, bottom - top)
  }

  /** Takes over the pixels of a box from an image of the whole map, in which the tile begins at (x, y). */
  take(image: ImageData, x: number, y: number, { left, top, right, bottom }: Box): void {
    this.#full.putImageData(image, -x, -y, left, top, right - left, bottom - top)
    this.#inTime = 0
  }

  /** The image for cells of this size in device pixels. */
  imageFor(cell: number): HTMLCanvasElement {
    let image = this.#full.canvas
    let size = cell
    for (let level = 0; size < HALF_BELOW; level++) {
      image = this.#halved(image, level)
      size *= 2
    }
    return image
  }

  #halved(image: HTMLCanvasElement, level: number): HTMLCanvasElement {
    this.#halves[level] ??= newContext(Math.ceil(image.width / 2), Math.ceil(image.height / 2))
    const half = this.#halves[level]
    if (level >= this.#inTime) {
      half.drawImage(image, 0, 0, half.canvas.width, half.canvas.height)
      this.#inTime = level + 1
    }
    return half.canvas
  }
}
