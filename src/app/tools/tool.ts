import type { Point } from '../../grid/grid'

/** What a pointer does from its press until it is let go. Places are CSS pixels on the screen. */
export interface Tool {
  /** The places that the pointer came by since the last time, in order. */
  move(places: readonly Point[]): void
  end(): void
  /** Takes back what was done. */
  cancel(): void
}
