import type { Grid } from '../grid/grid'
import type { Box } from './paint-cells'

/** The context of a canvas. @throws Error if the browser draws no canvas. */
export function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d')
  if (!context) throw new Error('This browser cannot draw on a canvas.')
  return context
}

/** The cell image on a canvas of its own, off the screen, from where it is drawn at any size. */
export class CellCanvas {
  readonly canvas = document.createElement('canvas')
  readonly #context = contextOf(this.canvas)
  #image: ImageData | null = null

  /** Takes over the pixels in `box`, from `pixels` with one pixel for each cell of the grid. */
  take(pixels: Uint32Array<ArrayBuffer>, { width, height }: Grid, box: Box): void {
    if (this.#image?.data.buffer !== pixels.buffer || this.#image.width !== width) {
      this.canvas.width = width
      this.canvas.height = height
      this.#image = new ImageData(new Uint8ClampedArray(pixels.buffer), width, height)
    }
    const { left, top, right, bottom } = box
    this.#context.putImageData(this.#image, 0, 0, left, top, right - left, bottom - top)
  }
}
