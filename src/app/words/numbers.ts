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

export const cellsInWords = (count: number): string => countInWords(count, 'cell')

/** Two digits that count; below the clock's resolution it says so. */
export function timeInWords(milliseconds: number): string {
  if (milliseconds < 0.1) return 'less than 0.1 ms'
  if (milliseconds < 9.95) return `${milliseconds.toFixed(1)} ms`
  if (milliseconds < 999.5) return `${Math.round(milliseconds)} ms`
  return `${(milliseconds / 1000).toFixed(1)} s`
}

/** A number as a table shows it, in words, with what it is called. */
export interface NumberRow {
  readonly label: string
  readonly value: string
}
