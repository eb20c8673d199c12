import type { Cell } from '../grid/grid'
import type { Problem } from '../grid/problem'
import type { Frame } from '../trace/frame'
import type { TapeColumns } from '../trace/tape'
import type { Theme } from './theme'

/** All that the drawing of the map depends on, apart from where the map lies on the screen. */
export interface Scene {
  readonly problem: Problem
  readonly theme: Theme
  /** The plan on screen and its picture at this moment; `null` while there is none. */
  readonly plan: { readonly tape: TapeColumns; readonly frame: Frame } | null
  /** Cells that the rover senses around it; 0 for planners without a rover. */
  readonly sensorRange: number
  /** Whether potentials are shown, as a heat map and, in large cells, as numbers. */
  readonly showPotential: boolean
  /** The keyboard's cell; -1 if the map is not being used by keyboard. */
  readonly cursor: Cell
}
