import type { Size } from '../../../grid/grid'

/**
 * A rectangle around all cells that were looked at, in one number: a byte for each side says how far
 * it reaches there, the more the farther. 0 is no rectangle at all.
 */
export type View = number

const MOST = 127
/** The highest bit of each byte, which views leave free. */
const HIGHEST = 0x80808080 | 0

/** Makes views of the cells of a map, in squares of 2^shift cells a side: so few that a byte counts them. */
export class Viewer {
  readonly #shift: number

  constructor({ width, height }: Size) {
    const last = Math.max(width, height) - 1
    this.#shift = 32 - Math.clz32(last / MOST)
  }

  /** Of columns from `left` to `right` and rows from `top` to `bottom`, or up to a square more. */
  view(left: number, top: number, right: number, bottom: number): View {
    const shift = this.#shift
    return (
      ((MOST - (left >> shift)) << 24) |
      ((MOST - (top >> shift)) << 16) |
      (((right >> shift) + 1) << 8) |
      ((bottom >> shift) + 1)
    )
  }
}

/** In each byte its highest bit, if `a` reaches there as far as `b`. No byte borrows from the next one. */
const asFar = (a: View, b: View): number => ((a | HIGHEST) - b) & HIGHEST

/** Whether all of `other` is within `view`. */
export const covers = (view: View, other: View): boolean => asFar(view, other) === HIGHEST

/** The rectangle around both. */
export function joined(a: View, b: View): View {
  const bytesOfA = Math.imul(asFar(a, b) >>> 7, 255)
  return (a & bytesOfA) | (b & ~bytesOfA)
}
