/** A number short enough for a narrow column: whole numbers whole, others with two decimals. */
export function numberInWords(value: number): string {
  if (Number.isNaN(value)) return '–'
  if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞'
  const rounded = Math.round(value * 100) / 100
  return rounded.toLocaleString('en', { maximumFractionDigits: 2 })
}

/** "1 step", "2 steps". */
export const countInWords = (count: number, what: string): string =>
  `${numberInWords(count)} ${what}${count === 1 ? '' : 's'}`
