import { closeSync, existsSync, ftruncateSync, openSync, writeSync } from 'node:fs'
import { mapsOf, type Origin, readOrigin } from '../experiments/results'
import { originToLine, parseLine } from '../experiments/results-json'
import { InputError } from '../grid/errors'
import { linesOf } from './lines'
import { type MapsThere, mapsThere } from './maps-there'

/** Where rows are written to, one map after the other. */
export interface RowsWriter {
  /** The first map that is not there yet. */
  readonly next: number
  write(lines: string): void
  close(): void
}

/** Writes to the standard output. */
export function printRows(origin: Origin): RowsWriter {
  process.stdout.write(`${originToLine(origin)}\n`)
  const { first } = mapsOf(origin)
  return { next: first, write: (lines) => void process.stdout.write(lines), close() {} }
}

/**
 * Writes to a file, behind the maps that are in it already. What a run that was broken off left half
 * written, a line or the rows of a map, is cut off.
 * @throws InputError if the file has something else in it, which is left as it is
 */
export function openRowsFile(path: string, origin: Origin): RowsWriter {
  const there = whatIsThere(path, origin)
  const isNew = there.end === 0
  const file = openSync(path, isNew ? 'w' : 'r+')
  ftruncateSync(file, there.end)
  let { end } = there
  const write = (lines: string) => {
    const text = Buffer.from(lines)
    for (let done = 0; done < text.length; ) {
      const written = writeSync(file, text, done, text.length - done, end)
      done += written
      end += written
    }
  }
  if (isNew) write(`${originToLine(origin)}\n`)
  return { next: there.next, write, close: () => closeSync(file) }
}

/** What is in the file, if it is there and is about the same. */
function whatIsThere(path: string, origin: Origin): MapsThere {
  const there = headerThere(path, origin)
  return there
    ? mapsThere(path, origin, there.header, there.lines)
    : { next: mapsOf(origin).first, end: 0 }
}

/**
 * The first line of a file of such rows, and those after it; `null` if there is no file, or none of
 * its lines is whole.
 * @throws InputError if the file has something else in it
 */
export function headerThere(path: string, origin: Origin) {
  if (!existsSync(path)) return null
  const lines = linesOf(path)
  const { value: header, done } = lines.next()
  if (done) return null
  if (!header.isWhole) {
    // A letter of several bytes may be cut, too.
    const cut = header.text.replace(/\uFFFD$/, '')
    if (!originToLine(origin).startsWith(cut)) throw isSomethingElse(path)
    return null
  }
  checkOrigin(path, header.text, origin)
  return { header, lines }
}

function checkOrigin(path: string, line: string, origin: Origin): void {
  let found: Origin
  try {
    found = readOrigin(parseLine(line, 1))
  } catch (error) {
    if (error instanceof InputError) throw isSomethingElse(path)
    throw error
  }
  const name = ({ shard }: Origin) => `shard ${shard.index}/${shard.of}`
  if (originToLine({ ...found, shard: origin.shard }) !== originToLine(origin)) {
    throw new InputError(
      `${path} has rows of other settings. It is left as it is: name another file, or delete it.`,
    )
  }
  if (name(found) !== name(origin)) {
    throw new InputError(
      `${path} has the rows of ${name(found)}, not of ${name(origin)}. It is left as it is: name another file.`,
    )
  }
}

const isSomethingElse = (path: string) =>
  new InputError(
    `${path} has no rows of an experiment in it. It is left as it is: name another file.`,
  )
