/** Work that can be left after each of its steps and gone on with later; in the end it has a result. */
export type Work<Result> = Generator<void, Result, void>

/**
 * Goes on with work until it is done or the time is up, but by one step at least, so that it comes
 * to its end on the slowest machine. Says whether it is done.
 */
export function runFor(work: Work<unknown>, isTimeUp: () => boolean): boolean {
  do {
    if (work.next().done) return true
  } while (!isTimeUp())
  return false
}

/** The result of work that may take as long as it likes. */
export function runToEnd<Result>(work: Work<Result>): Result {
  for (;;) {
    const step = work.next()
    if (step.done) return step.value
  }
}
