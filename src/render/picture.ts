import type { Scene } from './scene'
import type { View } from './view'

/**
 * The picture of the map: canvases one upon the other inside an element that is positioned and as
 * large as the screen. It shows a scene, knows nothing else and changes nothing.
 */
export class Picture {
  readonly #canvases: readonly HTMLCanvasElement[]

  constructor(host: HTMLElement) {
    this.#canvases = ['cells', 'roadmap', 'plan', 'marks'].map((name) => {
      const canvas = document.createElement('canvas')
      canvas.dataset.layer = name
      canvas.setAttribute('aria-hidden', 'true')
      canvas.style.cssText = 'position:absolute;inset:0;pointer-events:none'
      host.append(canvas)
      return canvas
    })
  }

  /** Size of the screen in CSS pixels; the next `draw` draws everything anew. */
  resize(width: number, height: number, devicePixelRatio: number): void {
    for (const canvas of this.#canvases) {
      canvas.width = Math.round(width * devicePixelRatio)
      canvas.height = Math.round(height * devicePixelRatio)
      canvas.style.width = `${width}px`
      canvas.style.height = `${height}px`
    }
  }

  /** Draws what has changed since the last time. To be called once in an animation frame. */
  draw(_scene: Scene, _view: View): void {}

  /** Takes the canvases out of the page. */
  dispose(): void {
    for (const canvas of this.#canvases) canvas.remove()
  }
}
