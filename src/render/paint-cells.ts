import { editedCells } from '../grid/edits'
import type { Cell } from '../grid/grid'
import { EVENT } from '../trace/events'
import type { Frame } from '../trace/frame'
import type { TapeColumns } from '../trace/tape'
import type { Box } from './box'
import { type CellColours, isShownObstacle, stateOf } from './cell-colour'
import { type FieldRange, heatLevel } from './heat'
import type { Sight } from './scene'

/** What the colours of cells depend on. */
export interface CellStates {
  readonly width: number
  readonly walls: Uint8Array
  readonly frame: Frame | null
  readonly sight: Sight
  /** Range of the field that was written last; `null` if fields are not shown. */
  readonly fieldRange: FieldRange | null
  readonly colours: CellColours
}

/** The pixel of a cell. */
function cellPixel(states: CellStates, cell: Cell): number {
  const { walls, frame, sight, fieldRange, colours } = states
  if (!frame) return colours.plain[walls[cell]]
  const field = frame.field && frame.fields[frame.field]
  if (field && fieldRange && !isShownObstacle(sight, walls[cell], frame.cells[cell])) {
    const level = heatLevel(fieldRange, field[cell])
    if (level >= 0) return colours.heat[level]
  }
  return colours.plain[stateOf(walls[cell], frame.cells[cell])]
}

/** Paints every cell of a box, one pixel each. */
export function paintBox(pixels: Uint32Array, states: CellStates, box: Box): void {
  const { width, walls, frame, fieldRange, colours } = states
  const { plain } = colours
  const hasHeat = frame?.field && fieldRange
  for (let y = box.top; y < box.bottom; y++) {
    const from = y * width + box.left
    const to = y * width + box.right
    if (!frame) {
      for (let cell = from; cell < to; cell++) pixels[cell] = plain[walls[cell]]
    } else if (hasHeat) {
      for (let cell = from; cell < to; cell++) pixels[cell] = cellPixel(states, cell)
    } else {
      const { cells } = frame
      for (let cell = from; cell < to; cell++) {
        pixels[cell] = plain[stateOf(walls[cell], cells[cell])]
      }
    }
  }
}

/** Paints the cells whose state is told by the events `from` up to `to` of the tape. */
export function paintEvents(
  pixels: Uint32Array,
  states: CellStates,
  tape: TapeColumns,
  from: number,
  to: number,
  painted: (cell: Cell) => void,
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
        pixels[cell] = cellPixel(states, cell)
        painted(cell)
      }
    }
  }
}

/** Paints the cells that were built up or cleared since `before`. */
export function paintEdits(
  pixels: Uint32Array,
  states: CellStates,
  before: Uint8Array,
  painted: (cell: Cell) => void,
): void {
  const { walls } = states
  for (const cell of editedCells(before, walls)) {
    if (walls[cell] === before[cell]) continue
    pixels[cell] = cellPixel(states, cell)
    painted(cell)
  }
}
