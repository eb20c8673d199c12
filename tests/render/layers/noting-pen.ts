import type { Point } from '../../../src/grid/grid'
import type { Pen } from '../../../src/render/pen'

export interface Circle extends Point {
  readonly radius: number
}

/** Something that was drawn: all that its path had in it, or a text with its place. */
export interface Shape {
  readonly by: 'fill' | 'stroke' | 'text'
  readonly colour: string
  readonly lines: readonly (readonly Point[])[]
  readonly circles: readonly Circle[]
  readonly text: string
  /** Of lines, in pixels. */
  readonly width: number
  readonly isDashed: boolean
}

/** A pen that only notes what it draws. */
export class NotingPen implements Pen {
  fillStyle = ''
  strokeStyle = ''
  lineWidth = 1
  lineJoin: CanvasLineJoin = 'miter'
  /** What others have left: no layer has use for it. */
  lineCap: CanvasLineCap = 'square'
  globalAlpha = 1
  font = ''
  textAlign: CanvasTextAlign = 'start'
  textBaseline: CanvasTextBaseline = 'alphabetic'
  readonly shapes: Shape[] = []
  #dash: readonly number[] = []
  /** At first what others have drawn: each layer has to begin a path of its own. */
  #lines: Point[][] = [[{ x: -1000, y: -1000 }]]
  #circles: Circle[] = [{ x: -1000, y: -1000, radius: 1 }]

  setLineDash(segments: Iterable<number>): void {
    this.#dash = [...segments]
  }

  beginPath(): void {
    this.#lines = []
    this.#circles = []
  }

  moveTo(x: number, y: number): void {
    this.#lines.push([{ x, y }])
  }

  lineTo(x: number, y: number): void {
    const line = this.#lines.at(-1)
    if (!line) throw new Error('A line has to begin somewhere.')
    line.push({ x, y })
  }

  closePath(): void {
    const line = this.#lines.at(-1)
    if (line) line.push(line[0])
  }

  /** A circle is drawn on from where the path is, so a new part of the path has to begin on it. */
  arc(x: number, y: number, radius: number, from: number, to: number): void {
    if (from !== 0 || to !== 2 * Math.PI) throw new Error('That is no circle.')
    const before = this.#lines.pop()
    if (before && (before.length > 1 || before[0].x !== x + radius || before[0].y !== y)) {
      throw new Error('A line leads to the circle.')
    }
    this.#circles.push({ x, y, radius })
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.#lines.push(cornersOf(x, y, width, height))
  }

  fill(): void {
    this.#note('fill', this.#lines, this.#circles)
  }

  stroke(): void {
    this.#checkEnds()
    this.#note('stroke', this.#lines, this.#circles)
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    this.#note('fill', [cornersOf(x, y, width, height)], [])
  }

  strokeRect(x: number, y: number, width: number, height: number): void {
    this.#checkEnds()
    this.#note('stroke', [cornersOf(x, y, width, height)], [])
  }

  fillText(text: string, x: number, y: number): void {
    this.#note('text', [[{ x, y }]], [], text)
  }

  /** Ends that reach out fill the gaps between dashes; dots are nothing but such ends. */
  #checkEnds(): void {
    const [dash] = this.#dash
    if (dash === undefined) return
    const cap = dash === 0 ? 'round' : 'butt'
    if (this.lineCap !== cap) throw new Error(`These dashes have ends that are ${this.lineCap}.`)
  }

  #note(by: Shape['by'], lines: Point[][], circles: Circle[], text = ''): void {
    const colour = by === 'stroke' ? this.strokeStyle : this.fillStyle
    const isDashed = this.#dash.length > 0
    this.shapes.push({ by, colour, lines, circles, text, width: this.lineWidth, isDashed })
  }
}

/** From the top left one, which is the last again. */
function cornersOf(x: number, y: number, width: number, height: number): Point[] {
  const [right, bottom] = [x + width, y + height]
  return [
    { x, y },
    { x: right, y },
    { x: right, y: bottom },
    { x, y: bottom },
    { x, y },
  ]
}

/** What is drawn. */
export function shapesOf(draw: (pen: Pen) => void): Shape[] {
  const pen = new NotingPen()
  draw(pen)
  return pen.shapes
}

/** The box around lines. */
export function boxOf(lines: Shape['lines']) {
  const xs = lines.flat().map(({ x }) => x)
  const ys = lines.flat().map(({ y }) => y)
  const [left, right] = [Math.min(...xs), Math.max(...xs)]
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)]
  return { left, top, right, bottom }
}
