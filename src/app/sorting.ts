/**
 * Orders two values of a column of a table, as `sort` wants it. NaN stands for no value and comes
 * last in either direction.
 */
export function compareValues(a: number | string, b: number | string, descending: boolean): number {
  const sign = descending ? -1 : 1
  if (typeof a === 'string' || typeof b === 'string') {
    return sign * String(a).localeCompare(String(b), 'en', { numeric: true })
  }
  const missing = Number(Number.isNaN(a)) - Number(Number.isNaN(b))
  return missing || sign * (a - b) || 0
}
