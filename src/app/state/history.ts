import { packWalls, unpackWalls } from '../../grid/formats/packed'
import type { Setup } from './setup'

/** A setup to go back to. Its obstacles are kept as bits: a large map would take 4 MB otherwise. */
interface Entry {
  readonly setup: Omit<Setup, 'problem'> & {
    readonly problem: Omit<Setup['problem'], 'grid'>
  }
  readonly width: number
  readonly height: number
  readonly bits: Uint8Array
}

/** What undo and redo lead to, the nearest last. A value. */
export interface History {
  readonly past: readonly Entry[]
  readonly future: readonly Entry[]
}

export const emptyHistory: History = { past: [], future: [] }

/** Bytes of obstacles that are kept; what lies further back is forgotten. */
const HISTORY_BYTES = 64 * 2 ** 20
const HISTORY_STEPS = 1000

/** Steps that leave the map as it is share its bits. */
const packed = new WeakMap<Uint8Array, Uint8Array>()

function pack(setup: Setup): Entry {
  const { grid, ...problem } = setup.problem
  const bits = packed.get(grid.walls) ?? packWalls(grid.walls)
  packed.set(grid.walls, bits)
  return { setup: { ...setup, problem }, width: grid.width, height: grid.height, bits }
}

/** If `like` has the same obstacles they are shared, so that undoing a parameter copies no map. */
function unpack({ setup, width, height, bits }: Entry, like: Setup): Setup {
  const { walls } = like.problem.grid
  const same = packed.get(walls) === bits
  const grid = { width, height, walls: same ? walls : unpackWalls(bits, width * height) }
  packed.set(grid.walls, bits)
  return { ...setup, problem: { ...setup.problem, grid } }
}

/** The latest entries whose obstacles together fit into `limit` bytes. */
function bounded(entries: readonly Entry[], limit: number): readonly Entry[] {
  const counted = new Set<Uint8Array>()
  let bytes = 0
  let first = entries.length
  while (first > 0 && entries.length - first < HISTORY_STEPS) {
    const { bits } = entries[first - 1]
    if (!counted.has(bits)) bytes += bits.length
    if (bytes > limit) break
    counted.add(bits)
    first--
  }
  return first === 0 ? entries : entries.slice(first)
}

/** Remembers `before` as the step to undo next; what was undone until now is forgotten. */
export function remember(history: History, before: Setup, limit = HISTORY_BYTES): History {
  return { past: bounded([...history.past, pack(before)], limit), future: [] }
}

export interface Travel {
  readonly history: History
  readonly setup: Setup
}

/** The setup before `present`, and the history in which `present` is the step to redo next. */
export function undo({ past, future }: History, present: Setup): Travel | null {
  const entry = past.at(-1)
  if (!entry) return null
  const history = { past: past.slice(0, -1), future: [...future, pack(present)] }
  return { history, setup: unpack(entry, present) }
}

export function redo({ past, future }: History, present: Setup): Travel | null {
  const entry = future.at(-1)
  if (!entry) return null
  const history = { past: [...past, pack(present)], future: future.slice(0, -1) }
  return { history, setup: unpack(entry, present) }
}
