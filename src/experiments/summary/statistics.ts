/** Two-sided 95 % of the normal distribution. */
const Z = 1.959963984540054

/** A share with the ends of its confidence interval, all from 0 to 1. */
export interface Share {
  readonly rate: number
  readonly low: number
  readonly high: number
}

/**
 * The share of `successes` in `total` with its 95 % confidence interval after E. B. Wilson,
 * "Probable inference, the law of succession, and statistical inference", 1927. Of nothing, all
 * shares are possible: NaN from 0 to 1.
 */
export function wilson(successes: number, total: number): Share {
  if (total === 0) return { rate: Number.NaN, low: 0, high: 1 }
  const rate = successes / total
  const z2 = Z * Z
  const middle = (successes + z2 / 2) / (total + z2)
  const half = (Z / (total + z2)) * Math.sqrt((successes * (total - successes)) / total + z2 / 4)
  return {
    rate,
    low: successes === 0 ? 0 : middle - half,
    high: successes === total ? 1 : middle + half,
  }
}

/** Where a list of numbers lies; all NaN if it is empty. */
export interface Quantiles {
  readonly least: number
  readonly lower: number
  readonly median: number
  readonly upper: number
  /** 95 of 100 are at most so large. */
  readonly high: number
  readonly greatest: number
  readonly mean: number
}

export function quantilesOf(values: readonly number[]): Quantiles {
  const sorted = Float64Array.from(values).sort()
  const at = (share: number) => quantile(sorted, share)
  return {
    least: at(0),
    lower: at(0.25),
    median: at(0.5),
    upper: at(0.75),
    high: at(0.95),
    greatest: at(1),
    mean: sorted.reduce((sum, value) => sum + value, 0) / sorted.length,
  }
}

/** Linear between the two values on either side (Hyndman and Fan's type 7, as most programs do). */
function quantile(sorted: Float64Array, share: number): number {
  if (sorted.length === 0) return Number.NaN
  const place = share * (sorted.length - 1)
  const below = Math.floor(place)
  const above = Math.ceil(place)
  return sorted[below] + (place - below) * (sorted[above] - sorted[below])
}
