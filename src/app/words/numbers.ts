import { plural } from '../../grid/plural'
import { inThousands } from '../../grid/thousands'

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

/** "1 step", "2 steps". */
export const countInWords = (count: number, what: string): string =>
  `${numberInWords(count)} ${plural(count, what)}`

export const cellsInWords = (count: number): string => countInWords(count, 'cell')

/** Two digits, but none that the clock does not have: a tick of it is 0.1 or 1 ms, by browser. */
export function timeInWords(milliseconds: number): string {
  const tenths = Math.round(milliseconds * 10)
  if (tenths === 0) return 'too short to measure'
  if (tenths < 100) return `${tenths / 10} ms`
  if (milliseconds < 999.5) return `${Math.round(milliseconds)} ms`
  return `${(milliseconds / 1000).toFixed(1)} s`
}

/** A number as a table shows it, in words, with what it is called. */
export interface NumberRow {
  readonly label: string
  readonly value: string
}
