import { contextOf } from './cell-canvas'

/** One of the canvases on top of each other. It remembers what it was drawn from. */
export class Sheet {
  readonly context: CanvasRenderingContext2D
  readonly #canvas: HTMLCanvasElement
  #drawnFrom: readonly unknown[] = []

  constructor(host: HTMLElement, name: string) {
    this.#canvas = document.createElement('canvas')
    this.#canvas.dataset.layer = name
    this.#canvas.setAttribute('aria-hidden', 'true')
    this.#canvas.style.cssText = 'position:absolute;inset:0;pointer-events:none'
    this.context = contextOf(this.#canvas)
    host.append(this.#canvas)
  }

  /** Size in CSS pixels. It is empty afterwards. */
  resize(width: number, height: number, devicePixelRatio: number): void {
    this.#canvas.width = Math.round(width * devicePixelRatio)
    this.#canvas.height = Math.round(height * devicePixelRatio)
    this.#canvas.style.width = `${width}px`
    this.#canvas.style.height = `${height}px`
    this.#drawnFrom = []
  }

  /** Whether any of the things it is drawn from is another than when this was asked last. */
  isOutdated(by: readonly unknown[]): boolean {
    const before = this.#drawnFrom
    this.#drawnFrom = by
    return by.length !== before.length || by.some((input, i) => !Object.is(input, before[i]))
  }

  clear(): void {
    this.context.clearRect(0, 0, this.#canvas.width, this.#canvas.height)
  }

  fill(colour: string): void {
    this.context.fillStyle = colour
    this.context.fillRect(0, 0, this.#canvas.width, this.#canvas.height)
  }

  remove(): void {
    this.#canvas.remove()
  }
}
