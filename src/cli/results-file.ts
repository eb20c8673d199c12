import { closeSync, ftruncateSync, openSync, readFileSync, writeSync } from 'node:fs'
import { type Origin, readOrigin } from '../experiments/results'
import { originToLine, parseLine } from '../experiments/results-json'
import { countWork } from '../experiments/settings'
import { rangeOfShard } from '../experiments/shards'
import { InputError } from '../grid/errors'
import { RowOrder } from './row-order'

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
  const { first } = rangeOfShard(origin.shard, countWork(origin.settings).maps)
  return { next: first, write: (lines) => void process.stdout.write(lines), close() {} }
}

/**
 * Writes to a file, behind the maps that are in it already. What a run that was broken off left half
 * written, a line or the rows of a map, is cut off.
 * @throws InputError if the file has something else in it, which is left as it is
 */
export function openRowsFile(path: string, origin: Origin): RowsWriter {
  const { next, bytes } = whatIsThere(path, origin)
  const file = openSync(path, bytes === 0 ? 'w' : 'r+')
  ftruncateSync(file, bytes)
  let end = bytes
  const write = (lines: string) => {
    const text = Buffer.from(lines)
    for (let done = 0; done < text.length; ) {
      const written = writeSync(file, text, done, text.length - done, end)
      done += written
      end += written
    }
  }
  if (bytes === 0) write(`${originToLine(origin)}\n`)
  return { next, write, close: () => closeSync(file) }
}

/** The first map that is not in the file, and how many bytes those before it take. */
function whatIsThere(path: string, origin: Origin): { next: number; bytes: number } {
  const content = readIfThere(path)
  const rows = new RowOrder(path, origin)
  const headerEnd = content.indexOf('\n')
  if (headerEnd < 0) {
    if (!`${originToLine(origin)}\n`.startsWith(content.toString())) throw isSomethingElse(path)
    return { next: rows.next, bytes: 0 }
  }
  checkOrigin(path, content.toString('utf8', 0, headerEnd), origin)
  let bytes = headerEnd + 1
  let from = bytes
  for (let number = 2; ; number++) {
    const lineEnd = content.indexOf('\n', from)
    if (lineEnd < 0) return { next: rows.next, bytes }
    const isMapComplete = rows.take(content.toString('utf8', from, lineEnd), number)
    from = lineEnd + 1
    if (isMapComplete) bytes = from
  }
}

function readIfThere(path: string): Buffer {
  try {
    return readFileSync(path)
  } catch (error) {
    if (error instanceof Error && 'code' in error && error.code === 'ENOENT') return Buffer.alloc(0)
    throw error
  }
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
