/**
 * What draws on a canvas.
 * @param isOpaque whether nothing behind it is ever to be seen: the browser has less to do then
 * @throws Error if the browser does not draw on canvases
 */
export function contextOf(canvas: HTMLCanvasElement, isOpaque = false): CanvasRenderingContext2D {
  const context = canvas.getContext('2d', { alpha: !isOpaque })
  if (!context) throw new Error('This browser cannot draw on a canvas.')
  return context
}

/** The context of a new canvas, of this size in pixels. */
export function newContext(width: number, height: number): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas')
  canvas.width = width
  canvas.height = height
  return contextOf(canvas)
}
