import type { Cell, Point } from '../../../src/grid/grid'
import { placeMap } from '../../../src/render/placement'
import { themes } from '../../../src/render/theme'

/** A map of 8 × 6 cells, each 40 pixels wide, the first at the top left. */
export const COLUMNS = 8
export const ROWS = 6
export const SIDE = 40
export const theme = themes.dark

/** As it lies on a screen of this size, which it fills if nothing is said. */
export const placeOn = (width = COLUMNS * SIDE, height = ROWS * SIDE) =>
  placeMap(
    { scale: SIDE, left: 0, top: 0 },
    { width: COLUMNS, height: ROWS },
    { width, height, pixel: 1 },
  )

export const place = placeOn()

export const cellAt = (x: number, y: number): Cell => y * COLUMNS + x

/** The middle of a cell on the screen. */
export const middleOf = (cell: Cell): Point => ({
  x: ((cell % COLUMNS) + 0.5) * SIDE,
  y: (Math.floor(cell / COLUMNS) + 0.5) * SIDE,
})
