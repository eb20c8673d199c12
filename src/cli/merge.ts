import { createReadStream, createWriteStream, renameSync, rmSync } from 'node:fs'
import { pipeline } from 'node:stream/promises'
import { mapsOf, type Origin, readOrigin } from '../experiments/results'
import { originToLine, parseLine } from '../experiments/results-json'
import { WHOLE } from '../experiments/shards'
import { InputError } from '../grid/errors'
import { linesOf } from './lines'
import { inFile, mapsThere } from './maps-there'
import { headerThere } from './results-file'

export interface ShardFile {
  readonly path: string
  readonly origin: Origin
  /** The byte where its rows begin, and the one behind them. */
  readonly first: number
  readonly end: number
}

/**
 * The files of all shards of an experiment, in their order.
 * @throws InputError that names the file that is not of these settings, not complete or there twice
 */
export function readShards(paths: readonly string[]): readonly ShardFile[] {
  const files = paths.map(readShardFile)
  files.sort((a, b) => a.origin.shard.index - b.origin.shard.index)
  checkTogether(files)
  return files
}

/**
 * Joins the files into the one that a single run makes. It takes its name when it is whole.
 * @param out path of the new file; `null` for the standard output
 * @throws InputError if `out` has something else in it than rows of the same maps
 */
export async function mergeShards(files: readonly ShardFile[], out: string | null): Promise<void> {
  if (out === null) return pipeline(rowsOf(files), process.stdout, { end: false })
  headerThere(out, { ...files[0].origin, shard: WHOLE })?.lines.return()
  const part = `${out}.part`
  try {
    await pipeline(rowsOf(files), createWriteStream(part))
    renameSync(part, out)
  } finally {
    rmSync(part, { force: true })
  }
}

/** What stands in the file of all of them. */
async function* rowsOf(files: readonly ShardFile[]) {
  yield `${originToLine({ ...files[0].origin, shard: WHOLE })}\n`
  for (const { path, first, end } of files) {
    // Its option `end` is the last byte that is read.
    if (first < end) yield* createReadStream(path, { start: first, end: end - 1 })
  }
}

function readShardFile(path: string): ShardFile {
  const lines = linesOf(path)
  const { value: header, done } = lines.next()
  if (done) throw new InputError(`${path} is empty.`)
  const origin = inFile(path, () => readOrigin(parseLine(header.text, 1)))
  const { next, end } = mapsThere(path, origin, header, lines)
  const maps = mapsOf(origin)
  if (next < maps.end) {
    throw new InputError(
      `${path} is not complete: ${maps.end - next} of its ${maps.end - maps.first} maps are missing. Run it again to go on.`,
    )
  }
  return { path, origin, first: header.end, end }
}

function checkTogether(files: readonly ShardFile[]): void {
  const [{ path, origin }] = files
  const { of } = origin.shard
  const seen = new Map<number, string>()
  for (const file of files) {
    const { shard } = file.origin
    if (
      originToLine({ ...file.origin, shard: WHOLE }) !== originToLine({ ...origin, shard: WHOLE })
    ) {
      throw new InputError(`${path} and ${file.path} are of different settings.`)
    }
    if (shard.of !== of) {
      throw new InputError(
        `${path} is shard ${origin.shard.index}/${of}, but ${file.path} is shard ${shard.index}/${shard.of}.`,
      )
    }
    const other = seen.get(shard.index)
    if (other)
      throw new InputError(`${other} and ${file.path} are both shard ${shard.index}/${of}.`)
    seen.set(shard.index, file.path)
  }
  for (let index = 1; index <= of; index++) {
    if (!seen.has(index)) throw new InputError(`Shard ${index}/${of} is missing.`)
  }
}
