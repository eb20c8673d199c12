import { type Cell, isInside, type Point, type Size } from '../grid/grid'

/** Where the map lies on the screen, in CSS pixels: the side of a cell, and the map's top left. */
export interface View {
  readonly scale: number
  readonly left: number
  readonly top: number
}

/** A rectangle of the screen, in CSS pixels. */
export interface Rect {
  readonly left: number
  readonly top: number
  readonly width: number
  readonly height: number
}

/** Size of the screen, in CSS pixels. */
export interface ScreenSize {
  readonly width: number
  readonly height: number
}

/** From this size on, cells have lines between them, and `fitView` gives them whole pixels. */
export const LINES_FROM = 6

/** `fitView` makes cells no larger, but on large screens. From it on, lines and marks grow with the cells. */
export const FULL_CELL = 56

const LARGEST_CELL = 160
/** So many cells side by side fill the room on a large screen: what has fewer is not blown up farther. */
const FEWEST_ACROSS = 15
const SHORTEST_MAP_SIDE = 128
const KEPT_ON_SCREEN = 48
const FIT_MARGIN = 16

/** Where a place on the screen lies on the map: fractions of cells, outside the map as well. */
export function pointAt(view: View, px: number, py: number): Point {
  return { x: (px - view.left) / view.scale, y: (py - view.top) / view.scale }
}

/** The cell under a place on the screen; -1 outside the map. */
export function cellAt(view: View, grid: Size, px: number, py: number): Cell {
  const point = pointAt(view, px, py)
  const x = Math.floor(point.x)
  const y = Math.floor(point.y)
  return isInside(grid, x, y) ? y * grid.width + x : -1
}

/** Where a cell is on the screen. */
export function cellRect(view: View, grid: Size, cell: Cell): Rect {
  const { scale, left, top } = view
  const x = cell % grid.width
  const y = Math.floor(cell / grid.width)
  return { left: left + x * scale, top: top + y * scale, width: scale, height: scale }
}

/** Least and greatest side of a cell: the whole of a large map, or a few cells of it, can be seen. */
export function scaleLimits(grid: Size): { readonly min: number; readonly max: number } {
  const fewest = SHORTEST_MAP_SIDE / Math.max(grid.width, grid.height)
  return { min: Math.min(fewest, LARGEST_CELL), max: LARGEST_CELL }
}

const clamp = (value: number, min: number, max: number): number =>
  Math.max(min, Math.min(value, max))

/** Makes cells `factor` times as large, as far as the limits go; the place at (px, py) stays. */
export function zoomAt(view: View, factor: number, px: number, py: number, grid: Size): View {
  const { min, max } = scaleLimits(grid)
  const scale = clamp(view.scale * factor, min, max)
  const ratio = scale / view.scale
  return { scale, left: px - (px - view.left) * ratio, top: py - (py - view.top) * ratio }
}

/** Moves the map back if it has left the screen, or all but left it. */
export function keepOnScreen(view: View, grid: Size, screen: ScreenSize): View {
  const kept = (start: number, length: number, room: number) => {
    const least = Math.min(KEPT_ON_SCREEN, length, room)
    return clamp(start, least - length, room - least)
  }
  const { scale } = view
  return {
    scale,
    left: kept(view.left, grid.width * scale, screen.width),
    top: kept(view.top, grid.height * scale, screen.height),
  }
}

/** Moves the map, but never off the screen altogether. */
export function panBy(view: View, dx: number, dy: number, grid: Size, screen: ScreenSize): View {
  return keepOnScreen({ ...view, left: view.left + dx, top: view.top + dy }, grid, screen)
}

/** The view that shows the whole map, as large as it gets, in the middle of `rect`. */
export function fitView(grid: Size, rect: Rect): View {
  const { min, max } = scaleLimits(grid)
  const [width, height] = [rect.width - 2 * FIT_MARGIN, rect.height - 2 * FIT_MARGIN]
  const largest = clamp(Math.min(width, height) / FEWEST_ACROSS, FULL_CELL, max)
  const fitting = Math.min(width / grid.width, height / grid.height, largest)
  const scale = Math.max(min, fitting >= LINES_FROM ? Math.floor(fitting) : fitting)
  return {
    scale,
    left: Math.round(rect.left + (rect.width - grid.width * scale) / 2),
    top: Math.round(rect.top + (rect.height - grid.height * scale) / 2),
  }
}
