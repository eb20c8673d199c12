import { InputError } from '../grid/errors'
import { hexOf } from './colour'
import type { Work } from './work'

/** More would make a file that no program opens with pleasure. */
export const MOST_RECTS = 200_000

/**
 * The cells as elements of an SVG file, one unit a cell: for each colour a path of rectangles, one
 * for each run of cells of that colour in a row.
 * @param pixels one for each cell, row by row
 * @throws InputError if that takes more than 200,000 rectangles
 */
export function* svgCells(pixels: Uint32Array, columns: number): Work<string> {
  const paths = new Map<number, string[]>()
  let count = 0
  for (let from = 0; from < pixels.length; ) {
    const pixel = pixels[from]
    const x = from % columns
    if (x === 0) yield
    const y = (from - x) / columns
    const rowEnd = from - x + columns
    let to = from + 1
    while (to < rowEnd && pixels[to] === pixel) to++
    if (++count > MOST_RECTS) {
      throw new InputError(
        `An SVG of this map needs more than ${MOST_RECTS.toLocaleString('en')} rectangles: save it as PNG instead.`,
      )
    }
    const rects = paths.get(pixel) ?? []
    paths.set(pixel, rects)
    rects.push(`M${x} ${y}h${to - from}v1h${from - to}z`)
    from = to
  }
  return Array.from(
    paths,
    ([pixel, rects]) => `<path fill="${hexOf(pixel)}" d="${rects.join('')}"/>`,
  ).join('\n')
}
