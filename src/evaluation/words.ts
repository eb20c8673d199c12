import type { Share } from '../experiments/summary/statistics'

export const count = (n: number): string => n.toLocaleString('en')

/** "3 of 20 maps". */
export const ofMaps = (part: number, all: number): string => `${count(part)} of ${count(all)} maps`

/** One decimal, but never 0 % or 100 % for what is not quite so. */
export function percent(share: number): string {
  if (Number.isNaN(share)) return '–'
  if (share > 0 && share < 0.0005) return '< 0.1 %'
  if (share < 1 && share > 0.9995) return '> 99.9 %'
  return `${(100 * share).toFixed(1)} %`
}

/** A share with its confidence interval: "96.3 % (95.9–96.7)". */
export function withInterval({ rate, low, high }: Share): string {
  const bare = (share: number) => (100 * share).toFixed(1)
  return `${percent(rate)} (${bare(low)}–${bare(high)})`
}

/** Three digits that count. */
export const figure = (value: number): string =>
  Number.isFinite(value) ? String(Number(value.toPrecision(3))) : '–'

export const milliseconds = (value: number): string => `${figure(value)} ms`

/** A Markdown table, its first column to the left and the others to the right. */
export function table(header: readonly string[], rows: readonly (readonly string[])[]): string {
  const line = (cells: readonly string[]) => `| ${cells.join(' | ')} |`
  const sides = header.map((_, i) => (i === 0 ? ':--' : '--:'))
  return [header, sides, ...rows].map(line).join('\n')
}

/** "a, b and c". */
export function list(items: readonly string[]): string {
  const last = items[items.length - 1]
  return items.length < 2 ? (last ?? '') : `${items.slice(0, -1).join(', ')} and ${last}`
}
