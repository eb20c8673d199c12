import type { Cell, Size } from '../grid/grid'
import type { Box } from './box'
import { FULL_CELL, type View } from './view'

/** Size of the screen in device pixels, and how many of them make a CSS pixel. */
export interface DeviceScreen {
  readonly width: number
  readonly height: number
  readonly pixel: number
}

/** Where the map lies on the canvases, in device pixels, and which part of it can be seen. */
export interface Placement {
  readonly columns: number
  readonly rows: number
  /** Side of a cell. */
  readonly cell: number
  /** Top left of the map: whole numbers, so that lines are crisp. */
  readonly left: number
  readonly top: number
  /** Device pixels in a CSS pixel, and more if cells are very large: the measure of lines and marks. */
  readonly pixel: number
  /** Columns `fromX` to `toX` - 1 and rows `fromY` to `toY` - 1 can be seen, at least partly. */
  readonly fromX: number
  readonly toX: number
  readonly fromY: number
  readonly toY: number
}

export function placeMap(view: View, { width, height }: Size, screen: DeviceScreen): Placement {
  const { pixel } = screen
  const cell = view.scale * pixel
  const left = Math.round(view.left * pixel)
  const top = Math.round(view.top * pixel)
  return {
    columns: width,
    rows: height,
    cell,
    left,
    top,
    pixel: pixel * Math.max(1, view.scale / FULL_CELL),
    fromX: Math.max(0, Math.floor(-left / cell)),
    toX: Math.min(width, Math.ceil((screen.width - left) / cell)),
    fromY: Math.max(0, Math.floor(-top / cell)),
    toY: Math.min(height, Math.ceil((screen.height - top) / cell)),
  }
}

/** The part of a placement in which some cells lie, with `margin` cells around them. */
export function placeOfBox(place: Placement, box: Box, margin: number): Placement {
  return {
    ...place,
    fromX: Math.max(place.fromX, box.left - margin),
    toX: Math.min(place.toX, box.right + margin),
    fromY: Math.max(place.fromY, box.top - margin),
    toY: Math.min(place.toY, box.bottom + margin),
  }
}

/** Whether any cell of a box can be seen. */
export function isBoxVisible(place: Placement, { left, top, right, bottom }: Box): boolean {
  return left < place.toX && right > place.fromX && top < place.toY && bottom > place.fromY
}

/** The device pixel at which column or row `i` begins: whole, so that neighbours meet exactly. */
export const edgeX = (place: Placement, x: number): number =>
  Math.round(place.left + x * place.cell)
export const edgeY = (place: Placement, y: number): number => Math.round(place.top + y * place.cell)

export const centreX = (place: Placement, cell: Cell): number =>
  place.left + ((cell % place.columns) + 0.5) * place.cell

export const centreY = (place: Placement, cell: Cell): number =>
  place.top + (Math.floor(cell / place.columns) + 0.5) * place.cell

/** A length that grows with the cells, in device pixels, within bounds in CSS pixels. */
export function inProportion(place: Placement, part: number, min: number, max: number): number {
  return Math.max(min * place.pixel, Math.min(part * place.cell, max * place.pixel))
}

/** Whether cells are at least this large, in CSS pixels. */
export function cellsAreAtLeast(place: Placement, size: number): boolean {
  return place.cell >= size * place.pixel
}

/** No mark reaches farther out of its cell than this, in CSS pixels. */
const MARK_REACH = 16

/** How many cells that is. */
export const reachOf = (place: Placement): number =>
  Math.ceil((MARK_REACH * place.pixel) / place.cell)

/** Whether a cell, or a mark in it that is larger than the cell, can be seen. */
export function isVisible(place: Placement, cell: Cell): boolean {
  const x = cell % place.columns
  const y = Math.floor(cell / place.columns)
  const reach = reachOf(place)
  return (
    x >= place.fromX - reach &&
    x < place.toX + reach &&
    y >= place.fromY - reach &&
    y < place.toY + reach
  )
}

/** Whether a line between two cells may be seen: its box meets the part of the map on screen. */
export function mayBeSeen(place: Placement, a: Cell, b: Cell): boolean {
  const ax = a % place.columns
  const bx = b % place.columns
  if (Math.max(ax, bx) < place.fromX - 1 || Math.min(ax, bx) > place.toX) return false
  const ay = Math.floor(a / place.columns)
  const by = Math.floor(b / place.columns)
  return Math.max(ay, by) >= place.fromY - 1 && Math.min(ay, by) <= place.toY
}

/**
 * More vertices or lines than this on one screen could hardly be told apart, nor drawn within a frame:
 * they are shown once one zooms in.
 */
export const MOST_IN_VIEW = 20_000

/** The cells that can be seen, and `margin` cells around them. */
export function boxInView({ fromX, toX, fromY, toY }: Placement, margin: number): Box {
  return { left: fromX - margin, top: fromY - margin, right: toX + margin, bottom: toY + margin }
}
