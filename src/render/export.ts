import { newContext } from './canvas'
import { CellCanvas } from './cell-canvas'
import { CellImage } from './cell-image'
import { drawGround, drawMarks, drawPlan } from './drawing'
import { edgeLines } from './edge-lines'
import type { FieldRange } from './heat'
import { drawBorder } from './layers/border'
import { drawComparison } from './layers/comparison'
import { drawEdges } from './layers/roadmap'
import type { Pen } from './pen'
import { type Placement, placeMap } from './placement'
import { planOnMap, type Scene } from './scene'
import { svgCells } from './svg-cells'
import { SvgPen, svgPaint } from './svg-pen'

/** Side of a cell in pixels, unless the map is too large for that. */
const PNG_CELL = 48
const SVG_CELL = 32
/** Longer side of the map in pixels up to which cells have that size. */
const LONGEST_SIDE = 4096
/** Around the map, as wide as it is on the screen: room for marks that are larger than their cells. */
const MARGIN = 8
/** With cells of this size, lines and marks are as wide as on the screen; they grow with larger ones. */
const SCREEN_CELL = 32

/** More vertices, or lines of a roadmap, than this are left out. */
const MOST_DRAWN = 100_000

/** A picture as a file, and whether vertices or edges are left out of it. */
interface SavedPicture<Content> {
  readonly content: Content
  readonly isCrowded: boolean
}

interface WholeMap {
  readonly place: Placement
  readonly width: number
  readonly height: number
}

/** The whole map with a margin around it. */
function wholeMap({ problem }: Scene, cell: number): WholeMap {
  const { grid } = problem
  const pixel = Math.max(1, cell / SCREEN_CELL)
  const margin = Math.ceil(MARGIN * pixel)
  const width = grid.width * cell + 2 * margin
  const height = grid.height * cell + 2 * margin
  const view = { scale: cell / pixel, left: margin / pixel, top: margin / pixel }
  return { place: placeMap(view, grid, { width, height, pixel }), width, height }
}

/** All that lies upon the cells. Returns whether vertices or edges are left out. */
function drawUponCells(
  pen: Pen,
  place: Placement,
  scene: Scene,
  range: FieldRange | null,
): boolean {
  const frame = planOnMap(scene)?.frame
  let isCrowded = false
  drawGround(pen, place, scene, range)
  if (frame) {
    const { vertices, edges, edgesCut } = frame
    const lines = edgeLines(place.columns, place.rows, edges)
    const [hidesEdges, hidesVertices] = [
      lines.length > 2 * MOST_DRAWN,
      vertices.length > MOST_DRAWN,
    ]
    if (!hidesEdges) drawEdges(pen, place, scene.theme, lines)
    drawPlan(pen, place, scene.theme, frame, hidesVertices ? [] : vertices)
    isCrowded = hidesEdges || hidesVertices || edgesCut
  }
  drawComparison(pen, place, scene.theme, scene.comparison)
  drawMarks(pen, place, scene)
  return isCrowded
}

/** Side of a cell: a whole number of pixels, `size` unless the picture would be too large. */
function cellSide({ problem }: Scene, size: number): number {
  const { width, height } = problem.grid
  return Math.floor(Math.min(size, LONGEST_SIDE / Math.max(width, height)))
}

/** Whether the browser gives out what was drawn on a canvas, give or take a little. */
function canBeRead(): boolean {
  const context = newContext(1, 1)
  context.fillStyle = 'rgb(40 80 160)'
  context.fillRect(0, 0, 1, 1)
  const { data } = context.getImageData(0, 0, 1, 1)
  return [40, 80, 160, 255].every((value, i) => Math.abs(value - data[i]) < 8)
}

/**
 * The picture of the whole map as a PNG.
 * @param rest lets the page go on. What is read of the frame is read between two rests: playing changes it
 * @throws Error if the browser cannot make a picture of this size, or gives out none
 */
export async function pictureAsPng(
  scene: Scene,
  rest: () => Promise<void>,
): Promise<SavedPicture<Blob>> {
  if (!canBeRead()) {
    throw new Error(
      'To guard your privacy, this browser gives out noise for what a page draws. Allow this page to read its canvases, or save an SVG.',
    )
  }
  const { place, width, height } = wholeMap(scene, cellSide(scene, PNG_CELL))
  const context = newContext(width, height)
  context.fillStyle = scene.theme.outside
  context.fillRect(0, 0, width, height)
  await rest()
  const image = new CellImage()
  const cells = new CellCanvas()
  const painted = image.update(scene)
  cells.take(image.pixels, scene.problem.grid, painted)
  drawBorder(context, place, scene.theme)
  cells.draw(context, place)
  const isCrowded = drawUponCells(context, place, scene, image.fieldRange)
  await rest()
  return new Promise((resolve, reject) => {
    context.canvas.toBlob((blob) => {
      if (blob) resolve({ content: blob, isCrowded })
      else reject(new Error('This browser cannot make a picture of this size.'))
    }, 'image/png')
  })
}

/**
 * The picture of the whole map as a standalone SVG file.
 * @throws InputError if the map's cells need too many rectangles
 */
export function pictureAsSvg(scene: Scene): SavedPicture<string> {
  const { theme, problem } = scene
  const image = new CellImage()
  image.update(scene)
  const cells = svgCells(image.pixels, problem.grid.width)
  const cell = cellSide(scene, SVG_CELL)
  const { place, width, height } = wholeMap(scene, cell)
  const below = new SvgPen()
  drawBorder(below, place, theme)
  const above = new SvgPen()
  const isCrowded = drawUponCells(above, place, scene, image.fieldRange)
  const content = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">
<title>Map of ${problem.grid.width} × ${problem.grid.height} cells</title>
<rect width="${width}" height="${height}"${svgPaint('fill', theme.outside)}/>
${below.elements()}
<g id="cells" transform="translate(${place.left} ${place.top}) scale(${cell})" shape-rendering="crispEdges">
${cells}
</g>
${above.elements()}
</svg>
`
  return { content, isCrowded }
}
