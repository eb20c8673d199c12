import { KNOWN, SEARCH } from '../trace/frame'
import { pixelOf, rgbOf } from './colour'
import { heatColours } from './heat'
import type { Sight } from './scene'
import type { Theme } from './theme'

/** The theme's colours of cells as pixels. */
export interface CellPalette {
  readonly free: number
  readonly open: number
  readonly closed: number
  readonly sensed: number
  readonly unsensed: number
  readonly obstacle: number
  readonly unsensedObstacle: number
  readonly feltObstacle: number
  /** One for each heat level. */
  readonly heat: Uint32Array
}

export function cellPalette(theme: Theme): CellPalette {
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
    heat: Uint32Array.from(heatColours(theme), pixelOf),
  }
}

/**
 * The pixel of an obstacle.
 * @param known one of KNOWN; it does not count if the world is shown
 */
export function obstacleColour(
  palette: CellPalette,
  sight: Sight,
  known: number,
  felt: number,
): number {
  if (felt) return palette.feltObstacle
  const isVeiled = sight !== 'world' && known !== KNOWN.obstacle
  return isVeiled ? palette.unsensedObstacle : palette.obstacle
}

/**
 * The pixel of a free cell.
 * @param search one of SEARCH
 * @param heat the level of its potential; -1 if that is not shown
 */
export function freeColour(
  palette: CellPalette,
  sight: Sight,
  known: number,
  search: number,
  heat: number,
): number {
  if (heat >= 0) return palette.heat[heat]
  if (sight !== 'world') return known === KNOWN.unknown ? palette.unsensed : palette.sensed
  if (search === SEARCH.closed) return palette.closed
  return search === SEARCH.open ? palette.open : palette.free
}
