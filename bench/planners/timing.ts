import { quantilesOf } from '../../src/experiments/summary/statistics'
import type { Target, Work } from './case'

/** Times of a unit of work in ms, taken in turn: ours[i] right before peer[i]. */
export interface Samples {
  readonly ours: readonly number[]
  readonly peer: readonly number[]
}

const WARM_UP_MS = 100
const LEAST_RUNS = 3
/** What takes so long is compiled on the way, and hardly notices that it is compiled again. */
const VERY_LONG_MS = 500
/** What is shorter is repeated within a sample, so that the clock's steps do not count. */
const SAMPLE_MS = 10
/** What takes longer leaves much garbage behind. */
const LONG_MS = 100
const MOST_ROUNDS = 15
const ENOUGH_MS = 600
const ALONE_MS = 50

/**
 * Times both in turn until there are enough samples.
 * @param isClose takes ten times as many
 */
export function timeInTurn(ours: Work, peer: Work, isClose = false): Samples {
  globalThis.gc?.()
  const once = { ours: warmUp(ours), peer: warmUp(peer) }
  const sweeping = Math.max(once.ours, once.peer) > LONG_MS
  const least = Math.max(once.ours, once.peer) > VERY_LONG_MS ? 3 : 5
  const samples: { ours: number[]; peer: number[] } = { ours: [], peer: [] }
  const times = isClose ? 10 : 1
  const end = performance.now() + times * ENOUGH_MS
  for (let round = 0; round < times * MOST_ROUNDS; round++) {
    if (round >= least && performance.now() > end) break
    samples.ours.push(sample(ours, once.ours, sweeping))
    samples.peer.push(sample(peer, once.peer, sweeping))
  }
  return samples
}

/** The median time of a unit of work, by itself; what takes long is timed once. */
export function timeAlone(work: Work): number {
  globalThis.gc?.()
  const once = warmUp(work)
  const samples: number[] = []
  const end = performance.now() + ALONE_MS
  do samples.push(sample(work, once, once > LONG_MS))
  while (performance.now() < end)
  return quantilesOf(samples).median
}

/**
 * Does the work until it has not become faster for a while, so that all of it is compiled; returns
 * the shortest time that it took, in ms.
 */
function warmUp(work: Work): number {
  let now = performance.now()
  let since = now
  let least = Number.POSITIVE_INFINITY
  for (let runs = 1; ; runs++) {
    const begin = now
    work()
    now = performance.now()
    if (now - begin < 0.9 * least) since = begin
    least = Math.min(least, now - begin)
    const enough = least > VERY_LONG_MS ? 1 : LEAST_RUNS
    if (runs >= enough && now - since >= WARM_UP_MS) return least
  }
}

/**
 * The time of a unit of work that takes `once` ms. Nobody shall pay for the garbage of another: the
 * young is cleared away, and all of it when `sweeping`, if Node lets us. As that throws compiled
 * code away, too, work is then warmed up as in the beginning, unless it takes very long.
 */
function sample(work: Work, once: number, sweeping: boolean): number {
  const times = Math.max(1, Math.ceil(SAMPLE_MS / once))
  if (sweeping) {
    globalThis.gc?.()
    if (once <= VERY_LONG_MS) warmUp(work)
  }
  globalThis.gc?.({ type: 'minor' })
  const begin = performance.now()
  const units = repeat(work, times)
  return (performance.now() - begin) / units
}

function repeat(work: Work, times: number): number {
  let units = 0
  for (let i = 0; i < times; i++) units += work()
  return units
}

/** What is read off the samples of a case. */
export interface Figures {
  /** Medians, in ms for a unit. */
  readonly ours: number
  readonly peer: number
  /** Median and quartiles of the ratios of the pairs, the way round that the target has them. */
  readonly ratio: number
  readonly lower: number
  readonly upper: number
  readonly met: boolean
}

export function figuresOf(target: Target, samples: Samples): Figures {
  const isAtMost = target !== null && 'atMost' in target
  const ratios = samples.ours.map((ours, i) =>
    isAtMost ? ours / samples.peer[i] : samples.peer[i] / ours,
  )
  const { median, lower, upper } = quantilesOf(ratios)
  return {
    ours: quantilesOf(samples.ours).median,
    peer: quantilesOf(samples.peer).median,
    ratio: median,
    lower,
    upper,
    met: isMet(target, median),
  }
}

export function isMet(target: Target, ratio: number): boolean {
  if (target === null) return true
  return 'atMost' in target ? ratio <= target.atMost : ratio >= target.atLeast
}
