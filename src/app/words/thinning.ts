import type { Thinning } from '../../trace/thinning'

/** What a long plan leaves out of its steps: beside their number, and as sentences; both may be empty. */
export interface LeftOut {
  readonly briefly: string
  readonly words: string
}

const LEFT_OUT: Record<Thinning, LeftOut> = {
  whole: { briefly: '', words: '' },
  thinned: {
    briefly: ', small things left out',
    words:
      'This plan is too long to keep all that happens in it. Small things are left out, such as cells that are opened or sensed, or the parts of a potential. The answer is not changed by that.',
  },
  cut: {
    briefly: ', not to the end',
    words:
      'This plan is too long to be shown to its end. Small things are left out, and all that comes after the last step here. The answer is not changed by that.',
  },
}

export const leftOut = (thinning: Thinning): LeftOut => LEFT_OUT[thinning]
