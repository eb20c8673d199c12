/**
 * How many milliseconds are left at the pace so far; `null` as long as nothing is done.
 * @param done of `total`, of which `before` were done when the clock started
 */
export function timeLeft(done: number, total: number, elapsed: number, before = 0): number | null {
  if (done <= before) return null
  return (elapsed / (done - before)) * (total - done)
}

/** "3 min 20 s": two units at most, as exact as a guess deserves. */
export function durationInWords(milliseconds: number): string {
  const seconds = Math.ceil(milliseconds / 1000)
  if (seconds < 60) return `${seconds} s`
  const minutes = Math.floor(seconds / 60)
  if (minutes < 60) return `${minutes} min ${seconds % 60} s`
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`
}
