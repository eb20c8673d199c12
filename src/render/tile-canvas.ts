import type { Box } from './box'
import { newContext } from './canvas'

/** Below this size of a cell, in device pixels, a tile is drawn from its half. */
const HALF_BELOW = 0.5

/**
 * The cells of one tile as an image, one pixel each, and the same at half the size once that is
 * asked for: a map as a whole is drawn from a quarter of the pixels.
 */
export class TileCanvas {
  readonly #full: CanvasRenderingContext2D
  #half: CanvasRenderingContext2D | null = null
  #isHalfLate = true

  constructor({ left, top, right, bottom }: Box) {
    this.#full = newContext(right - left, bottom - top)
  }

  /** Takes over the pixels of a box from an image of the whole map, in which the tile begins at (x, y). */
  take(image: ImageData, x: number, y: number, { left, top, right, bottom }: Box): void {
    this.#full.putImageData(image, -x, -y, left, top, right - left, bottom - top)
    this.#isHalfLate = true
  }

  /** The image for cells of this size in device pixels. */
  imageFor(cell: number): HTMLCanvasElement {
    return cell < HALF_BELOW ? this.#halved() : this.#full.canvas
  }

  #halved(): HTMLCanvasElement {
    const { canvas } = this.#full
    this.#half ??= newContext(Math.ceil(canvas.width / 2), Math.ceil(canvas.height / 2))
    const { width, height } = this.#half.canvas
    if (this.#isHalfLate) this.#half.drawImage(canvas, 0, 0, width, height)
    this.#isHalfLate = false
    return this.#half.canvas
  }
}
