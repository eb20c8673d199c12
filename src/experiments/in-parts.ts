import { ROWS_AT_ONCE, type Row } from './row'

/**
 * The texts of rows, many of them at a time, for files that take long to be written.
 * @param progress is told what share of the rows is written, from 0 to 1
 */
export function* inParts(
  rows: readonly Row[],
  textOf: (row: Row) => string,
  between: string,
  progress: ((done: number) => void) | undefined,
): Generator<string, void, void> {
  for (let i = 0; i < rows.length; i += ROWS_AT_ONCE) {
    progress?.(i / rows.length)
    const texts = rows.slice(i, i + ROWS_AT_ONCE).map(textOf)
    yield (i > 0 ? between : '') + texts.join(between)
  }
}
