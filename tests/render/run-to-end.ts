import type { Work } from '../../src/render/work'

/** The result of work that may take as long as it likes. */
export function runToEnd<Result>(work: Work<Result>): Result {
  for (;;) {
    const step = work.next()
    if (step.done) return step.value
  }
}
