/** Work to be timed. Returns how many units it did: queries, cells, or a part of a whole. */
export type Work = () => number

/**
 * What a ratio must be: so many times as fast as the peer, or at most so many times its time. With
 * `null` it is only shown, as so many times as fast.
 */
export type Target = { readonly atLeast: number } | { readonly atMost: number } | null

/** Two pieces of work that are timed in turn. */
export interface Case {
  readonly name: string
  /** What ours is held against, in words. */
  readonly against: string
  readonly ours: Work
  readonly peer: Work
  /** What a unit is: the time of a query is shown in milliseconds, that of a cell in nanoseconds. */
  readonly unit: 'query' | 'cell'
  readonly target: Target
  /** Whether little is between the two, so that it takes many more samples to tell. */
  readonly isClose?: boolean
}
