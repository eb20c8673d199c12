import { stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import { EVENT } from '../trace/events'
import type { Frame } from '../trace/frame'
import { kindTable } from '../trace/kind-table'
import type { Tape } from '../trace/tape'
import type { Box } from './box'
import { isShownObstacle, stateOf } from './cell-colour'
import { type FieldRange, heatLevel } from './heat'
import type { Sight } from './scene'

/** What the colours of cells depend on. */
export interface CellStates {
  readonly width: number
  readonly walls: Uint8Array
  readonly frame: Frame | null
  readonly sight: Sight
  /** By `stateOf`: the pixel of a cell without heat. */
  readonly colours: Uint32Array
  /** Of the field that was written last; `null` if fields are not shown. */
  readonly heat: { readonly range: FieldRange; readonly pixels: Uint32Array } | null
}

/** The pixel of a cell. */
function cellPixel(states: CellStates, cell: Cell): number {
  const { walls, frame, sight, heat, colours } = states
  if (!frame) return colours[walls[cell]]
  const field = frame.field && frame.fields[frame.field]
  if (field && heat && !isShownObstacle(sight, walls[cell], frame.cells[cell])) {
    const level = heatLevel(heat.range, field[cell])
    if (level >= 0) return heat.pixels[level]
  }
  return colours[stateOf(walls[cell], frame.cells[cell])]
}

/** Paints every cell of a box, one pixel each. */
export function paintBox(pixels: Uint32Array, states: CellStates, box: Box): void {
  const { width, walls, frame, heat, colours } = states
  const hasHeat = frame?.field && heat
  for (let y = box.top; y < box.bottom; y++) {
    const from = y * width + box.left
    const to = y * width + box.right
    if (!frame) {
      for (let cell = from; cell < to; cell++) pixels[cell] = colours[walls[cell]]
    } else if (hasHeat) {
      for (let cell = from; cell < to; cell++) pixels[cell] = cellPixel(states, cell)
    } else {
      const { cells } = frame
      for (let cell = from; cell < to; cell++) {
        pixels[cell] = colours[stateOf(walls[cell], cells[cell])]
      }
    }
  }
}

/** Events that change how their cell looks. */
const isPainted = kindTable([
  EVENT.open,
  EVENT.close,
  EVENT.sense,
  EVENT.feel,
  EVENT.attraction,
  EVENT.repulsion,
  EVENT.potential,
])

/** Paints the cells whose state is told by the events `from` up to `to` of the tape. */
export function paintEvents(
  pixels: Uint32Array,
  states: CellStates,
  tape: Tape,
  from: number,
  to: number,
  painted: (cell: Cell) => void,
): void {
  const offsets = stepOffsets(tape.width)
  const paint = (cell: Cell) => {
    const pixel = cellPixel(states, cell)
    // Many events change no pixel: the cell was open before, or has been closed since.
    if (pixels[cell] === pixel && !states.heat) return
    pixels[cell] = pixel
    painted(cell)
  }
  for (let i = from; i < to; i++) {
    const kind = tape.kind(i)
    const cell = tape.cell(i)
    if (isPainted[kind] === 0 || cell < 0) continue
    paint(cell)
    if (kind !== EVENT.close) continue
    for (let left = tape.other(i); left > 0; ) {
      const direction = 31 - Math.clz32(left)
      left ^= 1 << direction
      paint(cell + offsets[direction])
    }
  }
}

/** Paints those of the cells that were built up or cleared since `before`. */
export function paintEdits(
  pixels: Uint32Array,
  states: CellStates,
  before: Uint8Array,
  edited: readonly Cell[],
  painted: (cell: Cell) => void,
): void {
  const { walls } = states
  for (const cell of edited) {
    if (walls[cell] === before[cell]) continue
    pixels[cell] = cellPixel(states, cell)
    painted(cell)
  }
}
