import type { Box } from './box'
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
import { type Placement, placeMap, placeOfBox } from './placement'
import { planOnMap, type Scene, still } from './scene'
import { svgCells } from './svg-cells'
import { SvgPen, svgPaint } from './svg-pen'
import type { Work } from './work'

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
export interface SavedPicture<Content = string | Promise<Blob>> {
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

/** All that lies upon the cells. Its result is whether vertices or edges are left out. */
function* drawUponCells(
  pen: Pen,
  place: Placement,
  scene: Scene,
  range: FieldRange | null,
): Work<boolean> {
  const frame = planOnMap(scene)?.frame
  let isCrowded = false
  drawGround(pen, place, scene, range)
  yield
  if (frame) {
    const { vertices, edges, edgesCut } = frame
    const lines = yield* edgeLines(place.columns, place.rows, edges)
    const [hidesEdges, hidesVertices] = [
      lines.length > 2 * MOST_DRAWN,
      vertices.length > MOST_DRAWN,
    ]
    if (!hidesEdges) drawEdges(pen, place, scene.theme, lines)
    drawPlan(pen, place, scene.theme, frame, hidesVertices ? [] : vertices)
    isCrowded = hidesEdges || hidesVertices || edgesCut
    yield
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

/** Brings an image up to date tile by tile, and hands over the cells of each. */
function* paintTiles(
  image: CellImage,
  scene: Scene,
  painted: (cells: readonly Box[]) => void,
): Work<void> {
  do {
    let tiles = 0
    painted(image.update(scene, { isInView: () => true, isTimeUp: () => tiles++ > 0 }))
    yield
  } while (!image.isComplete)
}

/**
 * The picture of the whole map as a PNG, which the browser makes beside the page.
 * @throws Error if the browser cannot make a picture of this size, or gives out none
 */
export function* pictureAsPng(asked: Scene): Work<SavedPicture<Promise<Blob>>> {
  if (!canBeRead()) {
    throw new Error(
      'To guard your privacy, this browser gives out noise for what a page draws. Allow this page to read its canvases, or save an SVG.',
    )
  }
  const scene = still(asked)
  const { theme, problem } = scene
  const { place, width, height } = wholeMap(scene, cellSide(scene, PNG_CELL))
  yield
  const context = newContext(width, height)
  context.fillStyle = theme.outside
  context.fillRect(0, 0, width, height)
  drawBorder(context, place, theme)
  yield
  const image = new CellImage()
  const cells = new CellCanvas()
  yield* paintTiles(image, scene, (boxes) => {
    cells.take(image.pixels, problem.grid, boxes)
    for (const box of boxes) cells.draw(context, place, placeOfBox(place, box, 0))
  })
  const isCrowded = yield* drawUponCells(context, place, scene, image.fieldRange)
  return { content: pngOf(context.canvas), isCrowded }
}

function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob)
      else reject(new Error('This browser cannot make a picture of this size.'))
    }, 'image/png')
  })
}

/**
 * The picture of the whole map as a standalone SVG file.
 * @throws InputError if the map's cells need too many rectangles
 */
export function* pictureAsSvg(asked: Scene): Work<SavedPicture<string>> {
  const scene = still(asked)
  const { theme, problem } = scene
  const image = new CellImage()
  yield* paintTiles(image, scene, () => {})
  const cells = yield* svgCells(image.pixels, problem.grid.width)
  const cell = cellSide(scene, SVG_CELL)
  const { place, width, height } = wholeMap(scene, cell)
  const below = new SvgPen()
  drawBorder(below, place, theme)
  const above = new SvgPen()
  const isCrowded = yield* drawUponCells(above, place, scene, image.fieldRange)
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
