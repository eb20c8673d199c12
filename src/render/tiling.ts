import type { Size } from '../grid/grid'
import type { Box } from './box'

/** Side of a tile in cells, as a power of two. */
const TILE_BITS = 8
const TILE = 1 << TILE_BITS

/**
 * A map cut into squares. What changes in one of them leaves the images of the others as they are,
 * and a large map can be painted a few of them at a time.
 */
export interface Tiling {
  /** How many tiles lie beside each other. */
  readonly columns: number
  readonly boxes: readonly Box[]
}

export function tilingOf({ width, height }: Size): Tiling {
  const columns = Math.ceil(width / TILE)
  const rows = Math.ceil(height / TILE)
  const boxes = Array.from({ length: columns * rows }, (_, tile) => {
    const left = (tile % columns) * TILE
    const top = Math.floor(tile / columns) * TILE
    const [right, bottom] = [Math.min(left + TILE, width), Math.min(top + TILE, height)]
    return { left, top, right, bottom }
  })
  return { columns, boxes }
}

/** The tile in which the cell at (x, y) lies. */
export function tileAt({ columns }: Tiling, x: number, y: number): number {
  return (y >> TILE_BITS) * columns + (x >> TILE_BITS)
}
