import { closeSync, fstatSync, openSync, readSync } from 'node:fs'
import { InputError } from '../grid/errors'

const CHUNK_BYTES = 1 << 20
const LINE_END = 10

export interface Line {
  readonly text: string
  /** How many bytes the file has up to the end of this line. */
  readonly end: number
  /** Whether the line is all there; the last one of a run that was broken off may not be. */
  readonly isWhole: boolean
}

/**
 * The lines of a file, one after the other: it may be larger than what memory and strings can hold.
 * @throws InputError if it is a folder, a device or a pipe, of which no part can be read again
 */
export function* linesOf(path: string): Generator<Line, void> {
  const file = openSync(path, 'r')
  try {
    if (!fstatSync(file).isFile()) throw new InputError(`${path} is no file.`)
    const chunk = Buffer.alloc(CHUNK_BYTES)
    // A line may be as long as all maps of an experiment: its pieces are joined once, at its end.
    let pieces: Buffer[] = []
    let end = 0
    for (let count = readSync(file, chunk); count > 0; count = readSync(file, chunk)) {
      const bytes = Buffer.from(chunk.subarray(0, count))
      let from = 0
      for (let to = bytes.indexOf(LINE_END); to >= 0; to = bytes.indexOf(LINE_END, from)) {
        const last = bytes.subarray(from, to)
        const line = pieces.length > 0 ? Buffer.concat([...pieces, last]) : last
        end += line.length + 1
        yield { text: line.toString(), end, isWhole: true }
        pieces = []
        from = to + 1
      }
      if (from < count) pieces.push(bytes.subarray(from))
    }
    const rest = Buffer.concat(pieces)
    if (rest.length > 0) {
      yield { text: rest.toString(), end: end + rest.length, isWhole: false }
    }
  } finally {
    closeSync(file)
  }
}
