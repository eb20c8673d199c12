/**
 * A number short enough for a narrow column: whole numbers whole, others with two decimals. The
 * first call of `toLocaleString` costs a slow machine a tenth of a second.
 */
export function numberInWords(value: number): string {
  if (Number.isNaN(value)) return '–'
  if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞'
  const rounded = Math.round(value * 100) / 100
  return String(rounded).replace(/\B(?=(\d{3})+(\.|$))/g, ',')
}

/** "1 step", "2 steps". */
export const countInWords = (count: number, what: string): string =>
  `${numberInWords(count)} ${what}${count === 1 ? '' : 's'}`
