import {
  CELL_STATES,
  type CellState,
  isFeltIn,
  KNOWN,
  knownIn,
  SEARCH,
  searchIn,
} from '../trace/cell-state'
import { pixelOf, rgbOf } from './colour'
import type { Sight } from './scene'
import type { Theme } from './theme'

/** The theme's colours of cells as pixels. */
interface CellPalette {
  readonly free: number
  readonly open: number
  readonly closed: number
  readonly sensed: number
  readonly unsensed: number
  readonly obstacle: number
  readonly unsensedObstacle: number
  readonly feltObstacle: number
}

function cellPalette(theme: Theme): CellPalette {
  const pixel = (hex: string) => pixelOf(rgbOf(hex))
  return {
    free: pixel(theme.cell.free),
    open: pixel(theme.cell.open),
    closed: pixel(theme.cell.closed),
    sensed: pixel(theme.cell.sensed),
    unsensed: pixel(theme.cell.unsensed),
    obstacle: pixel(theme.obstacle.seen),
    unsensedObstacle: pixel(theme.obstacle.unsensed),
    feltObstacle: pixel(theme.obstacle.felt),
  }
}

/**
 * All that the colour of a cell without heat depends on, as one number: a map has millions of cells
 * to look up.
 * @param wall 1 for an obstacle
 */
export const stateOf = (wall: number, cell: CellState): number => wall | (cell << 1)

/** By `stateOf`: the pixel of each state that a cell without heat can be in. */
export function cellColours(theme: Theme, sight: Sight): Uint32Array {
  const palette = cellPalette(theme)
  return Uint32Array.from({ length: 2 * CELL_STATES }, (_, state) => {
    const [wall, cell] = [state & 1, state >> 1]
    return isShownObstacle(sight, wall, cell)
      ? obstacleColour(palette, sight, cell)
      : freeColour(palette, sight, cell)
  })
}

/** Whether a cell looks like an obstacle: it is one, and known if only what is known is shown. */
export function isShownObstacle(sight: Sight, wall: number, cell: CellState): boolean {
  return wall === 1 && (sight !== 'known' || knownIn(cell) === KNOWN.obstacle || isFeltIn(cell))
}

function obstacleColour(palette: CellPalette, sight: Sight, cell: CellState): number {
  if (isFeltIn(cell)) return palette.feltObstacle
  const isVeiled = sight !== 'world' && knownIn(cell) !== KNOWN.obstacle
  return isVeiled ? palette.unsensedObstacle : palette.obstacle
}

function freeColour(palette: CellPalette, sight: Sight, cell: CellState): number {
  if (sight !== 'world') {
    return knownIn(cell) === KNOWN.unknown ? palette.unsensed : palette.sensed
  }
  if (searchIn(cell) === SEARCH.closed) return palette.closed
  return searchIn(cell) === SEARCH.open ? palette.open : palette.free
}
