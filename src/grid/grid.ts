import { noteEdit } from './edits'

/** Index of a cell, `y * width + x`; (0, 0) is the top left of the map. */
export type Cell = number

/** The side lengths of a map in cells. */
export interface Size {
  readonly width: number
  readonly height: number
}

/** A map of free cells (0) and obstacles (1), row by row. All outside it is obstacle. Never mutated. */
export interface Grid extends Size {
  readonly walls: Uint8Array
}

/** A place in map coordinates: column `x` from the left, row `y` from the top. */
export interface Point {
  readonly x: number
  readonly y: number
}

export const isSameSize = (a: Size, b: Size): boolean =>
  a.width === b.width && a.height === b.height

export const isSamePlace = (a: Point, b: Point): boolean => a.x === b.x && a.y === b.y

/** Least and greatest number of cells on a side of a map. */
export const MIN_SIDE = 2
export const MAX_SIDE = 2048

export function emptyGrid(width: number, height: number): Grid {
  return { width, height, walls: new Uint8Array(width * height) }
}

export function isInside({ width, height }: Size, x: number, y: number): boolean {
  return x >= 0 && y >= 0 && x < width && y < height
}

/** Whether (x, y) is an obstacle; everything outside the map is. */
export function isObstacle(grid: Grid, x: number, y: number): boolean {
  return !isInside(grid, x, y) || grid.walls[y * grid.width + x] === 1
}

export function pointOf(width: number, cell: Cell): Point {
  return { x: cell % width, y: Math.floor(cell / width) }
}

/**
 * The row of a cell, for inner loops: multiplied by `share`, because a division takes longer. Half a
 * cell is added so that rounding cannot lead into the row before.
 * @param share 1 / width of the map
 */
export const rowOf = (cell: Cell, share: number): number => ((cell + 0.5) * share) | 0

/** "(3, 7)": how a place is named in every message. */
export const placeName = ({ x, y }: Point): string => `(${x}, ${y})`

/** "(3, 7)": the name of the place of a cell. */
export const cellName = (width: number, cell: Cell): string => placeName(pointOf(width, cell))

/** The grid with each of `cells` made an obstacle or free; the given grid is left as it is. */
export function withCells(grid: Grid, cells: readonly Cell[], obstacle: boolean): Grid {
  const walls = grid.walls.slice()
  for (const cell of cells) walls[cell] = obstacle ? 1 : 0
  noteEdit(grid.walls, walls, cells)
  return { ...grid, walls }
}

/** The map cut or extended with free cells at the right and the bottom. */
export function resized(grid: Grid, width: number, height: number): Grid {
  const walls = new Uint8Array(width * height)
  const columns = Math.min(width, grid.width)
  for (let y = 0; y < Math.min(height, grid.height); y++) {
    walls.set(grid.walls.subarray(y * grid.width, y * grid.width + columns), y * width)
  }
  return { width, height, walls }
}
