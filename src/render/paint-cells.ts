import type { Cell } from '../grid/grid'
import { EVENT } from '../trace/events'
import type { Frame } from '../trace/frame'
import type { TapeColumns } from '../trace/tape'
import { type CellPalette, freeColour, obstacleColour } from './cell-colour'
import { type FieldRange, heatLevel } from './heat'
import { isKnownObstacle } from './known-obstacles'
import type { Sight } from './scene'

/** What the colours of cells depend on. */
export interface CellStates {
  readonly walls: Uint8Array
  readonly frame: Frame | null
  readonly sight: Sight
  /** Range of the field that was written last; `null` if fields are not shown. */
  readonly fieldRange: FieldRange | null
}

/** The smallest box around the cells that were repainted; `right` and `bottom` lie outside it. */
export interface Box {
  left: number
  top: number
  right: number
  bottom: number
}

export function emptyBox(): Box {
  return { left: Number.POSITIVE_INFINITY, top: Number.POSITIVE_INFINITY, right: 0, bottom: 0 }
}

function include(box: Box, x: number, y: number): void {
  if (x < box.left) box.left = x
  if (y < box.top) box.top = y
  if (x >= box.right) box.right = x + 1
  if (y >= box.bottom) box.bottom = y + 1
}

/** The pixel of a cell. */
export function cellPixel(states: CellStates, palette: CellPalette, cell: Cell): number {
  const { walls, frame, sight, fieldRange } = states
  if (!frame) return walls[cell] ? palette.obstacle : palette.free
  if (sight === 'known' ? isKnownObstacle(walls, frame, cell) : walls[cell]) {
    return obstacleColour(palette, sight, frame.known[cell], frame.felt[cell])
  }
  const field = frame.field && frame.fields[frame.field]
  const heat = field && fieldRange ? heatLevel(fieldRange, field[cell]) : -1
  return freeColour(palette, sight, frame.known[cell], frame.search[cell], heat)
}

/** Paints every cell, one pixel each, row by row. */
export function paintCells(pixels: Uint32Array, states: CellStates, palette: CellPalette): void {
  for (let cell = 0; cell < pixels.length; cell++) {
    pixels[cell] = cellPixel(states, palette, cell)
  }
}

/** Paints the cells whose state is told by the events `from` up to `to` of the tape. */
export function paintEvents(
  pixels: Uint32Array,
  states: CellStates,
  palette: CellPalette,
  tape: TapeColumns,
  from: number,
  to: number,
  box: Box,
): void {
  for (let i = from; i < to; i++) {
    switch (tape.kinds[i]) {
      case EVENT.open:
      case EVENT.close:
      case EVENT.sense:
      case EVENT.feel:
      case EVENT.attraction:
      case EVENT.repulsion:
      case EVENT.potential: {
        const cell = tape.cells[i]
        if (cell < 0) break
        pixels[cell] = cellPixel(states, palette, cell)
        include(box, cell % tape.width, Math.floor(cell / tape.width))
      }
    }
  }
}

/** Paints the cells that were built up or cleared since `before`, on a map `width` cells wide. */
export function paintEdits(
  pixels: Uint32Array,
  states: CellStates,
  palette: CellPalette,
  before: Uint8Array,
  width: number,
  box: Box,
): void {
  const { walls } = states
  for (let cell = 0; cell < walls.length; cell++) {
    if (walls[cell] === before[cell]) continue
    pixels[cell] = cellPixel(states, palette, cell)
    include(box, cell % width, Math.floor(cell / width))
  }
}
