import { quantilesOf } from '../src/experiments/summary/statistics'
import type { Target, Work } from './case'

/** Times of a unit of work in ms, taken in turn: ours[i] right before peer[i]. */
export interface Samples {
  readonly ours: readonly number[]
  readonly peer: readonly number[]
}

const WARM_UP_MS = 100
/** What is shorter is repeated within a sample, so that neither the clock nor one hiccup counts. */
const SAMPLE_MS = 20
/** What takes longer hardly notices that it has to be compiled again. */
const SHORT_MS = 100
const LEAST_ROUNDS = 5
const MOST_ROUNDS = 15
const ENOUGH_MS = 1500
const ALONE_MS = 200

/** Times both in turn until there are enough samples. */
export function timeInTurn(ours: Work, peer: Work): Samples {
  const sampleOurs = sampler(ours)
  const samplePeer = sampler(peer)
  const samples: { ours: number[]; peer: number[] } = { ours: [], peer: [] }
  const end = performance.now() + ENOUGH_MS
  for (let round = 0; round < MOST_ROUNDS; round++) {
    if (round >= LEAST_ROUNDS && performance.now() > end) break
    samples.ours.push(sampleOurs())
    samples.peer.push(samplePeer())
  }
  return samples
}

/** The median time of a unit of work, by itself; what takes long is timed once. */
export function timeAlone(work: Work): number {
  const sample = sampler(work)
  const samples: number[] = []
  const end = performance.now() + ALONE_MS
  do samples.push(sample())
  while (performance.now() < end)
  return quantilesOf(samples).median
}

/**
 * Warms the work up; returns what takes a sample of it. Each begins with a swept heap, if Node lets
 * us, so that nobody pays for another's garbage. But the sweep takes compiled code along, so short
 * work is warmed up again.
 */
function sampler(work: Work): () => number {
  const once = warmUp(work)
  const repeats = Math.max(1, Math.ceil(SAMPLE_MS / once))
  return () => {
    globalThis.gc?.()
    if (once < SHORT_MS) {
      repeat(work, repeats)
      globalThis.gc?.({ type: 'minor' })
    }
    const begin = performance.now()
    const units = repeat(work, repeats)
    return (performance.now() - begin) / units
  }
}

/** Returns the shortest time that the work took, in ms. */
function warmUp(work: Work): number {
  const begin = performance.now()
  let now = begin
  let least = Number.POSITIVE_INFINITY
  do {
    const last = now
    work()
    now = performance.now()
    least = Math.min(least, now - last)
  } while (now - begin < WARM_UP_MS)
  return least
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
