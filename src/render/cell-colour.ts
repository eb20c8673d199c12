import { KNOWN, SEARCH } from '../trace/frame'
import { pixelOf, rgbOf } from './colour'
import { heatColours } from './heat'
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

/** The pixel of each state that a cell can be in, and of each level of heat. */
export interface CellColours {
  /** By `stateOf`. */
  readonly plain: Uint32Array
  readonly heat: Uint32Array
}

const STATES = 64

/**
 * All that the colour of a cell without heat depends on, as one number: a map has millions of cells
 * to look up.
 * @param wall 1 for an obstacle
 * @param search one of SEARCH
 * @param known one of KNOWN
 * @param felt 1 if the rover felt it
 */
export function stateOf(wall: number, search: number, known: number, felt: number): number {
  return wall | (search << 1) | (known << 3) | (felt << 5)
}

export function cellColours(theme: Theme, sight: Sight): CellColours {
  const palette = cellPalette(theme)
  const plain = Uint32Array.from({ length: STATES }, (_, state) => {
    const [search, known, felt] = [(state >> 1) & 3, (state >> 3) & 3, state >> 5]
    return isShownObstacle(sight, state & 1, known, felt)
      ? obstacleColour(palette, sight, known, felt)
      : freeColour(palette, sight, known, search)
  })
  return { plain, heat: Uint32Array.from(heatColours(theme), pixelOf) }
}

/** Whether a cell looks like an obstacle: it is one, and known if only what is known is shown. */
export function isShownObstacle(sight: Sight, wall: number, known: number, felt: number): boolean {
  return wall === 1 && (sight !== 'known' || known === KNOWN.obstacle || felt === 1)
}

function obstacleColour(palette: CellPalette, sight: Sight, known: number, felt: number): number {
  if (felt) return palette.feltObstacle
  const isVeiled = sight !== 'world' && known !== KNOWN.obstacle
  return isVeiled ? palette.unsensedObstacle : palette.obstacle
}

function freeColour(palette: CellPalette, sight: Sight, known: number, search: number): number {
  if (sight !== 'world') return known === KNOWN.unknown ? palette.unsensed : palette.sensed
  if (search === SEARCH.closed) return palette.closed
  return search === SEARCH.open ? palette.open : palette.free
}
