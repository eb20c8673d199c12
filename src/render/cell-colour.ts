import { FELT_BIT, KNOWN, KNOWN_BITS, KNOWN_SHIFT, SEARCH, SEARCH_BITS } from '../trace/frame'
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

const STATES = 64

/**
 * All that the colour of a cell without heat depends on, as one number: a map has millions of cells
 * to look up.
 * @param wall 1 for an obstacle
 * @param cell its byte in a frame
 */
export const stateOf = (wall: number, cell: number): number => wall | (cell << 1)

/** By `stateOf`: the pixel of each state that a cell without heat can be in. */
export function cellColours(theme: Theme, sight: Sight): Uint32Array {
  const palette = cellPalette(theme)
  return Uint32Array.from({ length: STATES }, (_, state) => {
    const [wall, cell] = [state & 1, state >> 1]
    const known = (cell & KNOWN_BITS) >> KNOWN_SHIFT
    return isShownObstacle(sight, wall, cell)
      ? obstacleColour(palette, sight, known, (cell & FELT_BIT) !== 0)
      : freeColour(palette, sight, known, cell & SEARCH_BITS)
  })
}

/**
 * Whether a cell looks like an obstacle: it is one, and known if only what is known is shown.
 * @param cell its byte in a frame
 */
export function isShownObstacle(sight: Sight, wall: number, cell: number): boolean {
  const isKnown = (cell & KNOWN_BITS) >> KNOWN_SHIFT === KNOWN.obstacle || (cell & FELT_BIT) !== 0
  return wall === 1 && (sight !== 'known' || isKnown)
}

function obstacleColour(palette: CellPalette, sight: Sight, known: number, felt: boolean): number {
  if (felt) return palette.feltObstacle
  const isVeiled = sight !== 'world' && known !== KNOWN.obstacle
  return isVeiled ? palette.unsensedObstacle : palette.obstacle
}

function freeColour(palette: CellPalette, sight: Sight, known: number, search: number): number {
  if (sight !== 'world') return known === KNOWN.unknown ? palette.unsensed : palette.sensed
  if (search === SEARCH.closed) return palette.closed
  return search === SEARCH.open ? palette.open : palette.free
}
