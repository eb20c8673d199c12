/** Turns a value into a place between two pixels. */
export interface Scale {
  readonly ticks: readonly number[]
  place(value: number): number
}

/** From the first tick to the last one; ticks rise. */
export function linearScale(ticks: readonly number[], from: number, to: number): Scale {
  const first = ticks[0]
  const span = ticks[ticks.length - 1] - first
  return { ticks, place: (value) => from + ((value - first) / span) * (to - from) }
}

/** Logarithmic, from the least to the greatest of the values, with ticks at 1, 2 and 5 times powers of 10. */
export function logScale(values: readonly number[], from: number, to: number): Scale {
  const least = Math.log10(Math.min(...values))
  const greatest = Math.log10(Math.max(...values))
  const margin = 0.05 * (greatest - least || 1)
  const first = least - margin
  const span = greatest + margin - first
  const ticks: number[] = []
  for (let power = Math.floor(first); power <= first + span; power++) {
    for (const digit of [1, 2, 5]) {
      const tick = digit * 10 ** power
      if (Math.log10(tick) >= first && Math.log10(tick) <= first + span) ticks.push(tick)
    }
  }
  return { ticks, place: (value) => from + ((Math.log10(value) - first) / span) * (to - from) }
}
