import { createReadStream, createWriteStream, renameSync } from 'node:fs'
import { createInterface } from 'node:readline'
import { pipeline } from 'node:stream/promises'
import { type Origin, readOrigin } from '../experiments/results'
import { originToLine, parseLine } from '../experiments/results-json'
import { WHOLE } from '../experiments/shards'
import { InputError } from '../grid/errors'
import { inFile } from './in-file'
import { RowOrder } from './row-order'

interface ShardFile {
  readonly path: string
  readonly origin: Origin
  /** How many bytes stand before the first row. */
  readonly headerBytes: number
}

/**
 * Joins the files of all shards of an experiment into the file that a single run makes. All of them
 * are checked before anything is written, and the new file takes its name when it is whole.
 * @param out path of the new file; `null` for the standard output
 * @throws InputError that names the file that is not of these settings, not complete or there twice
 */
export async function mergeShards(paths: readonly string[], out: string | null): Promise<void> {
  const files: ShardFile[] = []
  for (const path of paths) files.push(await readShardFile(path))
  files.sort((a, b) => a.origin.shard.index - b.origin.shard.index)
  checkTogether(files)
  const part = out === null ? null : `${out}.part`
  const target = part === null ? process.stdout : createWriteStream(part)
  target.write(`${originToLine({ ...files[0].origin, shard: WHOLE })}\n`)
  for (const { path, headerBytes } of files) {
    await pipeline(createReadStream(path, { start: headerBytes }), target, { end: false })
  }
  if (part === null || out === null) return
  await new Promise<void>((resolve) => target.end(resolve))
  renameSync(part, out)
}

/** Reads all of the file, to see that each row is there and in its place. */
async function readShardFile(path: string): Promise<ShardFile> {
  let file: { readonly shard: ShardFile; readonly rows: RowOrder } | null = null
  let number = 0
  for await (const line of createInterface({ input: createReadStream(path), crlfDelay: 0 })) {
    number++
    if (file) {
      file.rows.take(line, number)
      continue
    }
    const origin = inFile(path, () => readOrigin(parseLine(line, 1)))
    const shard = { path, origin, headerBytes: Buffer.byteLength(line) + 1 }
    file = { shard, rows: new RowOrder(path, origin) }
  }
  if (file === null) throw new InputError(`${path} is empty.`)
  const { next, maps } = file.rows
  if (next < maps.end) {
    throw new InputError(
      `${path} is not complete: ${maps.end - next} of its ${maps.end - maps.first} maps are missing. Run it again to go on.`,
    )
  }
  return file.shard
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
      throw new InputError(`${path} is one of ${of} shards, ${file.path} one of ${shard.of}.`)
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
