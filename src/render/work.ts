/** Work that can be interrupted after each of its steps and continued later; it ends with a result. */
export type Work<Result> = Generator<void, Result, void>

/**
 * Goes on with work until it is done or the time is up, but for one step at least, so that it comes
 * to its end even on the slowest machine. Returns whether it is done.
 */
export function runFor(work: Work<unknown>, isTimeUp: () => boolean): boolean {
  do {
    if (work.next().done) return true
  } while (!isTimeUp())
  return false
}
