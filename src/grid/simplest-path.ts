import { type Direction, DX, DY, directionOf } from './directions'
import { type Cell, isSamePlace, type Point } from './grid'

/**
 * The simplest path (the report's "dummy path") goes diagonally while both axes differ and then
 * straight, whatever is in the way. Its next step depends only on where it is and where it goes, so
 * that it can be followed by asking for one step at a time.
 */
export function simplestStep(from: Point, to: Point): Direction {
  return directionOf(to.x - from.x, to.y - from.y)
}

/** Number of steps of the simplest path: the "distance" of the online planners (Chebyshev). */
export function distance(a: Point, b: Point): number {
  return Math.max(Math.abs(a.x - b.x), Math.abs(a.y - b.y))
}

/** Cost of the simplest path between two cells of a map; a straight step costs 1. */
export function simplestPathCost(a: Cell, b: Cell, width: number, diagonalCost: number): number {
  const rowA = Math.floor(a / width)
  const rowB = Math.floor(b / width)
  const across = Math.abs(a - rowA * width - (b - rowB * width))
  return costAcross(across, Math.abs(rowA - rowB), diagonalCost - 1)
}

/** The same by how many columns and rows they are apart; a diagonal step costs 1 + `more`. */
export function costAcross(across: number, down: number, more: number): number {
  return across > down ? across + more * down : down + more * across
}

/** Not by `Math.hypot`, which every engine may round in its own way; a root is the same everywhere. */
export function euclideanDistance(a: Point, b: Point): number {
  return Math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2)
}

/** The square of a Euclidean distance on a map is less: 2 · 2047² < 2²⁴. */
const MORE_THAN_ANY_SQUARE = 2 ** 24

/**
 * One number that orders places by how far they are from `to`: by distance, ties by Euclidean
 * distance. Exact for all maps, because it is an integer below 2^53.
 */
export function farness(from: Point, to: Point): number {
  const dx = from.x - to.x
  const dy = from.y - to.y
  return distance(from, to) * MORE_THAN_ANY_SQUARE + dx * dx + dy * dy
}

/** The cells of the simplest path, both ends included. */
export function simplestPath(width: number, from: Cell, to: Cell): Int32Array {
  let x = from % width
  let y = Math.floor(from / width)
  const end = { x: to % width, y: Math.floor(to / width) }
  const cells = new Int32Array(distance({ x, y }, end) + 1)
  for (let i = 0; i < cells.length; i++) {
    cells[i] = y * width + x
    const d = simplestStep({ x, y }, end)
    if (d < 0) break
    x += DX[d]
    y += DY[d]
  }
  return cells
}

/** The place after so many steps of the simplest path; `to` if it has no more. */
export function placeOnSimplestPath(from: Point, to: Point, steps: number): Point {
  const along = (a: number, b: number) => a + Math.sign(b - a) * Math.min(steps, Math.abs(b - a))
  return { x: along(from.x, to.x), y: along(from.y, to.y) }
}

/** Which cell of the simplest path from `from` to `to` the point is, counted from 0; -1 if none. */
export function indexOnSimplestPath(from: Point, to: Point, point: Point): number {
  const i = distance(from, point)
  return isSamePlace(point, placeOnSimplestPath(from, to, i)) ? i : -1
}
