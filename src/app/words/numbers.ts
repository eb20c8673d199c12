import { plural } from '../../grid/plural'

/**
 * A number short enough for a narrow column: whole numbers whole, others with two decimals. The
 * first call of `toLocaleString` costs a slow machine a tenth of a second.
 */
export function numberInWords(value: number): string {
  if (Number.isNaN(value)) return '–'
  if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞'
  return inThousands(String(Math.round(value * 100) / 100))
}

/** A length in cell sides, always with two decimals, so that lengths stand below each other. */
export const lengthInWords = (length: number): string => inThousands(length.toFixed(2))

/** @param digits with two decimals at most */
const inThousands = (digits: string): string => digits.replace(/\B(?=(\d{3})+(\.|$))/g, ',')

/** "1 step", "2 steps". */
export const countInWords = (count: number, what: string): string =>
  `${numberInWords(count)} ${plural(count, what)}`
