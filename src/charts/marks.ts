import type * as Plot from '@observablehq/plot'
import type { Mark } from './chart'

/** Names a mark by its number in `chart.marks`. */
export const MARK_ATTRIBUTE = 'data-mark'

/**
 * Options that make a button of each mark drawn from `drawn`, with its words for those who do not
 * see it, and for those who hover.
 * @param all marks of the chart, which give them their numbers
 */
export function asButtons(drawn: readonly Mark[], all: readonly Mark[]): Plot.MarkOptions {
  const numbers = new Map(all.map((mark, number) => [mark, number]))
  return {
    ariaLabel: (mark: Mark) => mark.label,
    title: (mark: Mark) => mark.label,
    render(index, scales, values, dimensions, context, next) {
      const group = next?.(index, scales, values, dimensions, context) ?? null
      // Plot draws an element for each number in the index, in that order.
      Array.from(group?.children ?? []).forEach((element, i) => {
        element.setAttribute(MARK_ATTRIBUTE, String(numbers.get(drawn[index[i]])))
        element.setAttribute('role', 'button')
        element.setAttribute('tabindex', '-1')
      })
      return group
    },
  }
}
