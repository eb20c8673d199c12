import { contextOf } from './canvas'
import { edgeX, edgeY, type Placement } from './placement'

/** One of the canvases on top of each other. It remembers what it was drawn from. */
export class Sheet {
  readonly #canvas: HTMLCanvasElement
  readonly #isOpaque: boolean
  #context: CanvasRenderingContext2D | null = null
  #drawnFrom: readonly unknown[] = []
  #isBlank = true

  /** @param isOpaque whether all of it is always filled, so that what is behind it is not seen */
  constructor(host: HTMLElement, name: string, isOpaque = false) {
    this.#isOpaque = isOpaque
    this.#canvas = document.createElement('canvas')
    this.#canvas.dataset.layer = name
    this.#canvas.setAttribute('aria-hidden', 'true')
    this.#canvas.style.cssText = 'position:absolute;inset:0;pointer-events:none'
    host.append(this.#canvas)
  }

  /** Made when it is drawn on first: most sheets of a plan stay blank. */
  get context(): CanvasRenderingContext2D {
    this.#context ??= contextOf(this.#canvas, this.#isOpaque)
    return this.#context
  }

  /** Size in CSS pixels. It is empty afterwards. */
  resize(width: number, height: number, devicePixelRatio: number): void {
    this.#canvas.width = Math.round(width * devicePixelRatio)
    this.#canvas.height = Math.round(height * devicePixelRatio)
    this.#canvas.style.width = `${width}px`
    this.#canvas.style.height = `${height}px`
    this.#drawnFrom = []
    this.#isBlank = true
  }

  /** Whether anything that it is drawn from has changed since this was asked last. */
  isOutdated(by: readonly unknown[]): boolean {
    const before = this.#drawnFrom
    this.#drawnFrom = by
    return by.length !== before.length || by.some((input, i) => !Object.is(input, before[i]))
  }

  /**
   * Draws it anew. A sheet that was blank and stays blank is left alone: for the browser, a canvas as
   * large as the screen that has changed is more work than most drawings.
   */
  redraw(hasContent: boolean, draw: () => void): void {
    if (!hasContent && this.#isBlank) return
    this.context.clearRect(0, 0, this.#canvas.width, this.#canvas.height)
    this.#isBlank = !hasContent
    if (hasContent) draw()
  }

  fill(colour: string): void {
    this.context.fillStyle = colour
    this.context.fillRect(0, 0, this.#canvas.width, this.#canvas.height)
  }

  /** Draws only where the cells of the placement lie. */
  within(part: Placement, draw: () => void): void {
    const { context } = this
    const [left, top] = [edgeX(part, part.fromX), edgeY(part, part.fromY)]
    context.save()
    context.beginPath()
    context.rect(left, top, edgeX(part, part.toX) - left, edgeY(part, part.toY) - top)
    context.clip()
    draw()
    context.restore()
  }
}
