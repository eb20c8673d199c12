const THOUSAND = 1000
const MILLION = 1_000_000

/** A potential in at most four signs, as far as a cell has room: 7, 7.5, 950, 5002, 18k, 2.1M. */
export function potentialLabel(potential: number): string {
  if (!Number.isFinite(potential)) return ''
  if (potential < 100) return String(Math.round(potential * 10) / 10)
  const whole = Math.round(potential)
  if (whole < 10 * THOUSAND) return String(whole)
  const thousands = Math.round(whole / THOUSAND)
  if (thousands < THOUSAND) return `${thousands}k`
  return `${Math.round(whole / (MILLION / 10)) / 10}M`
}
