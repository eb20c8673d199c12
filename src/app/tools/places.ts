import type { Point } from '../../grid/grid'
import { pointAt, type View } from '../../render/view'

/** The column and row under a place on the screen, outside the map as well. */
export function placeOnMap(view: View, place: Point): Point {
  const { x, y } = pointAt(view, place.x, place.y)
  return { x: Math.floor(x), y: Math.floor(y) }
}
