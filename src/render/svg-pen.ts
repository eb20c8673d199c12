import type { Pen } from './pen'

/** A number with at most two decimals, as short as it gets. */
const short = (value: number): string => String(Math.round(value * 100) / 100)

const RGBA = /^rgba\((\d+), (\d+), (\d+), ([\d.]+)\)$/

/** An attribute for a colour, and one for its opacity where it is not full. */
export function svgPaint(name: 'fill' | 'stroke', colour: string, opacity = 1): string {
  const [, red, green, blue, alpha = '1'] = RGBA.exec(colour) ?? []
  const opaque = red === undefined ? colour : `rgb(${red},${green},${blue})`
  const part = Number(alpha) * opacity
  return ` ${name}="${opaque}"${part === 1 ? '' : ` ${name}-opacity="${short(part)}"`}`
}

export function svgText(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;')
}

const ANCHORS = { center: 'middle', left: 'start', start: 'start', right: 'end', end: 'end' }

/** Draws the layers as the elements of an SVG file, in the same units. */
export class SvgPen implements Pen {
  fillStyle = '#000000'
  strokeStyle = '#000000'
  lineWidth = 1
  lineJoin: CanvasLineJoin = 'miter'
  lineCap: CanvasLineCap = 'butt'
  globalAlpha = 1
  font = '10px sans-serif'
  textAlign: CanvasTextAlign = 'start'
  textBaseline: CanvasTextBaseline = 'alphabetic'
  readonly #elements: string[] = []
  #dash: readonly number[] = []
  #path = ''
  /** Rectangles that are filled one after the other in one colour become one element. */
  #rects = ''
  #rectsPaint = ''

  /** The elements drawn so far. */
  elements(): string {
    this.#flush()
    return this.#elements.join('\n')
  }

  setLineDash(segments: Iterable<number>): void {
    this.#dash = [...segments]
  }

  beginPath(): void {
    this.#path = ''
  }

  closePath(): void {
    this.#path += 'z'
  }

  moveTo(x: number, y: number): void {
    this.#path += `M${short(x)} ${short(y)}`
  }

  lineTo(x: number, y: number): void {
    this.#path += `L${short(x)} ${short(y)}`
  }

  /** Clockwise; a whole circle is two halves, because an arc that ends where it begins is none. */
  arc(x: number, y: number, radius: number, from: number, to: number): void {
    const at = (angle: number) =>
      `${short(x + radius * Math.cos(angle))} ${short(y + radius * Math.sin(angle))}`
    const r = short(radius)
    const middle = (from + to) / 2
    const begin = this.#path === '' ? 'M' : 'L'
    this.#path += `${begin}${at(from)}A${r} ${r} 0 0 1 ${at(middle)}A${r} ${r} 0 0 1 ${at(to)}`
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.#path += rectPath(x, y, width, height)
  }

  fill(): void {
    this.#add(`<path d="${this.#path}"${this.#fillPaint()}/>`, this.#path)
  }

  stroke(): void {
    this.#stroke(this.#path)
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    const paint = this.#fillPaint()
    if (paint !== this.#rectsPaint) this.#flush()
    this.#rectsPaint = paint
    this.#rects += rectPath(x, y, width, height)
  }

  strokeRect(x: number, y: number, width: number, height: number): void {
    this.#stroke(rectPath(x, y, width, height))
  }

  fillText(text: string, x: number, y: number): void {
    const align = `text-anchor="${ANCHORS[this.textAlign]}"`
    const baseline = this.textBaseline === 'middle' ? ' dominant-baseline="central"' : ''
    const place = `x="${short(x)}" y="${short(y)}"`
    const style = `style="font:${svgText(this.font)}"`
    this.#add(
      `<text ${place} ${align}${baseline} ${style}${this.#fillPaint()}>${svgText(text)}</text>`,
      text,
    )
  }

  #fillPaint(): string {
    return svgPaint('fill', this.fillStyle, this.globalAlpha)
  }

  #stroke(path: string): void {
    const paint = svgPaint('stroke', this.strokeStyle, this.globalAlpha)
    const width = ` stroke-width="${short(this.lineWidth)}"`
    const join = ` stroke-linejoin="${this.lineJoin}" stroke-linecap="${this.lineCap}"`
    const dash =
      this.#dash.length > 0 ? ` stroke-dasharray="${this.#dash.map(short).join(' ')}"` : ''
    this.#add(`<path d="${path}" fill="none"${paint}${width}${join}${dash}/>`, path)
  }

  /** Adds an element unless there is nothing in it to see. */
  #add(element: string, content: string): void {
    if (content === '') return
    this.#flush()
    this.#elements.push(element)
  }

  #flush(): void {
    if (this.#rects === '') return
    this.#elements.push(`<path d="${this.#rects}"${this.#rectsPaint}/>`)
    this.#rects = ''
  }
}

function rectPath(x: number, y: number, width: number, height: number): string {
  return `M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}z`
}
