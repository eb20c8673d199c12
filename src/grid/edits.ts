import type { Cell } from './grid'
import { int32View } from './int32-view'

/** What was changed to make some walls of others, which may be forgotten. */
interface Edit {
  readonly before: WeakRef<Uint8Array>
  readonly cells: readonly Cell[]
}

const edits = new WeakMap<Uint8Array, Edit>()

/** Notes that `walls` differ from `before` in no other cells than these. */
export function noteEdit(before: Uint8Array, walls: Uint8Array, cells: readonly Cell[]): void {
  edits.set(walls, { before: new WeakRef(before), cells })
}

/**
 * The cells in which two maps of the same size may differ, maybe some of them more than once. Maps
 * of which one was made of the other, a few edits ago, need not be compared cell by cell; where others
 * differ in more than `most`, only some of these cells are given, more than `most`.
 */
export function editedCells(before: Uint8Array, walls: Uint8Array, most?: number): readonly Cell[] {
  return notedCells(before, walls) ?? notedCells(walls, before) ?? differences(before, walls, most)
}

/** More edits than this, and it is as quick to compare. */
const MOST_EDITS = 16

function notedCells(before: Uint8Array, walls: Uint8Array): readonly Cell[] | null {
  const cells: Cell[] = []
  let here: Uint8Array | undefined = walls
  for (let i = 0; i < MOST_EDITS && here && here !== before; i++) {
    const edit = edits.get(here)
    for (const cell of edit?.cells ?? []) cells.push(cell)
    here = edit?.before.deref()
  }
  return here === before ? cells : null
}

/** Node compares bytes as fast as memory can be read; browsers have nothing like it. */
const compareBytes = (globalThis as { Buffer?: { compare(a: Uint8Array, b: Uint8Array): number } })
  .Buffer?.compare

/**
 * The cells in which two maps of the same size differ, found by comparing them. It stops once there
 * are more than `most`.
 */
export function differences(
  a: Uint8Array,
  b: Uint8Array,
  most = Number.POSITIVE_INFINITY,
): readonly Cell[] {
  if (compareBytes?.(a, b) === 0) return []
  const cells: Cell[] = []
  // Four cells at a time, of millions.
  const [as, bs] = [int32View(a), int32View(b)]
  const words = Math.min(as.length, bs.length)
  for (let i = 0; cells.length <= most; i++) {
    while (i < words && as[i] === bs[i]) i++
    if (i >= words) break
    for (let cell = 4 * i; cell < 4 * i + 4; cell++) if (a[cell] !== b[cell]) cells.push(cell)
  }
  for (let cell = 4 * words; cell < a.length && cells.length <= most; cell++) {
    if (a[cell] !== b[cell]) cells.push(cell)
  }
  return cells
}
