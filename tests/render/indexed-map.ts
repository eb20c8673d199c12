import { randomInteger, randomNumbers } from '../../src/grid/random'
import { placeMap } from '../../src/render/placement'

export const COLUMNS = 300
export const ROWS = 200
export const CELLS = COLUMNS * ROWS

export const random = randomNumbers(11)
export const randomCells = (count: number) =>
  Int32Array.from({ length: count }, () => randomInteger(random, CELLS))

/** A view of the map's left upper corner. */
export const place = (scale: number) =>
  placeMap(
    { scale, left: 0, top: 0 },
    { width: COLUMNS, height: ROWS },
    { width: 600, height: 400, pixel: 1 },
  )

/** Lines as texts, in an order of their own. */
export const linesOf = (pairs: ArrayLike<number>) =>
  Array.from({ length: pairs.length / 2 }, (_, i) => `${pairs[2 * i]}-${pairs[2 * i + 1]}`).sort()
