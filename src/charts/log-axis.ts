import type { Mark } from './chart'

/** What a logarithmic axis shows, in the unit of its marks. */
export type Range = readonly [least: number, greatest: number]

/** The domain of a logarithmic axis for these marks. What of intervals lies near 0 is cut off. */
export function frameOf(marks: readonly Mark[]): Range {
  if (marks.length === 0) return [1, 10]
  const least = Math.min(...marks.map(({ y }) => y))
  const greatest = Math.max(...marks.map(({ high }) => high))
  return [least / 2, greatest * 1.3]
}

/** The powers of ten in a range; if there are fewer than two, their doubles and fivefolds as well. */
export function logTicks([least, greatest]: Range): number[] {
  const first = Math.floor(Math.log10(least))
  const last = Math.floor(Math.log10(greatest))
  // Read from texts, because `10 ** n` may be off by a rounding error.
  const multiples = (...digits: number[]) =>
    Array.from({ length: last - first + 1 }, (_, i) =>
      digits.map((d) => Number(`${d}e${first + i}`)),
    )
      .flat()
      .filter((tick) => tick >= least && tick <= greatest)
  const decades = multiples(1)
  return decades.length > 1 ? decades : multiples(1, 2, 5)
}
