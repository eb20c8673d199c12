import type { Cell, Grid } from '../grid/grid'
import type { Frame } from '../trace/frame'
import { isShownObstacle } from './cell-colour'
import type { Placement } from './placement'

/** Whether the rover knows the obstacle in a cell: its sensor saw it, or the rover felt it. */
export function isKnownObstacle(walls: Uint8Array, { cells }: Frame, cell: Cell): boolean {
  return isShownObstacle('known', walls[cell], cells[cell])
}

/** The map with the obstacles that the rover knows and no others, as far as it is on the screen. */
export function knownGrid({ width, height, walls }: Grid, frame: Frame, place: Placement): Grid {
  const known = new Uint8Array(walls.length)
  // One cell more on each side, because the neighbours count for what is drawn of a cell.
  for (let y = Math.max(0, place.fromY - 1); y < Math.min(height, place.toY + 1); y++) {
    for (let x = Math.max(0, place.fromX - 1); x < Math.min(width, place.toX + 1); x++) {
      const cell = y * width + x
      if (isKnownObstacle(walls, frame, cell)) known[cell] = 1
    }
  }
  return { width, height, walls: known }
}
