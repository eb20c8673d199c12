import type { Success } from '../experiments/summary/success'
import { inThousands } from '../grid/thousands'

export const count = (value: number): string => inThousands(String(value))

/** 0.914 → "91.4 %". */
export const percent = (share: number): string =>
  Number.isNaN(share) ? '–' : `${(100 * share).toFixed(1)} %`

/** "91.4 % (183 of 200; 95 % interval 86.7 % to 94.6 %)". */
export function successInWords({ rate, low, high, rows, failures }: Success): string {
  if (rows.length === 0) return 'no goal that can be reached'
  const reached = rows.length - failures.length
  return `${percent(rate)} (${count(reached)} of ${count(rows.length)}; 95 % interval ${percent(low)} to ${percent(high)})`
}

export const ratioInWords = (ratio: number): string =>
  Number.isNaN(ratio) ? '–' : ratio.toFixed(3)

/** Two digits that count: 0.0123 → "12 µs", 7.25 → "7.3 ms". */
export function millisecondsInWords(value: number): string {
  if (Number.isNaN(value)) return '–'
  if (value === 0) return 'too short to measure'
  const microseconds = Number((1000 * value).toPrecision(2))
  if (microseconds < 1000) return `${microseconds} µs`
  return `${microseconds < 100_000 ? microseconds / 1000 : count(Math.round(value))} ms`
}

/** A quantile of times that were read off a clock, which tells nothing that is less than its tick. */
export const quantileInWords = (milliseconds: number, tick: number): string =>
  milliseconds < tick ? `under ${millisecondsInWords(tick)}` : millisecondsInWords(milliseconds)
