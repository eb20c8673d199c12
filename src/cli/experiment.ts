import { readFileSync } from 'node:fs'
import { isMainThread } from 'node:worker_threads'
import { mapsOf } from '../experiments/results'
import type { ExperimentSettings } from '../experiments/settings'
import { readSettings } from '../experiments/settings-check'
import { type Command, readCommand, USAGE } from './command'
import { whileLocked } from './lock'
import { mergeShards, readShards } from './merge'
import { runMaps, serve } from './pool'
import { Progress } from './progress'
import { openRowsFile, printRows } from './results-file'
import { endWithReader, tell } from './tell'

/** As a shell has it for a program that Ctrl-C ended. */
const INTERRUPTED = 130

type CommandOf<Kind> = Extract<Command, { readonly kind: Kind }>

async function main(): Promise<void> {
  const command = readCommand(process.argv.slice(2))
  if (command.kind === 'help') process.stdout.write(USAGE)
  else if (command.kind === 'merge') await merge(command)
  else await run(command)
}

/** What is read is checked before anything is made, a folder or a lock. */
async function merge({ files, out }: CommandOf<'merge'>): Promise<void> {
  const shards = readShards(files)
  await whileLocked(out, () => mergeShards(shards, out))
}

async function run(command: CommandOf<'run'>): Promise<void> {
  const settings = readSettings(readFileSync(command.settings, 'utf8'))
  await whileLocked(command.out, () => runShard(settings, command))
}

async function runShard(
  settings: ExperimentSettings,
  { shard, out, workers }: CommandOf<'run'>,
): Promise<void> {
  const origin = { settings, shard }
  const writer = out === null ? printRows(origin) : openRowsFile(out, origin)
  const { first, end } = mapsOf(origin)
  const maps = { first: writer.next, end }
  if (out !== null && maps.first === end) {
    process.stderr.write(`${out} is complete: nothing is left to run.\n`)
  }
  const progress = new Progress(end - first, writer.next - first)
  const stop = new AbortController()
  for (const signal of ['SIGINT', 'SIGTERM'] as const) {
    process.on(signal, () => stop.abort())
  }
  const job = { settings, maps, workers, program: new URL(import.meta.url), signal: stop.signal }
  try {
    await runMaps(job, (lines) => {
      writer.write(lines)
      progress.add()
    })
  } finally {
    progress.end()
    writer.close()
  }
  if (!stop.signal.aborted) return
  const again = out === null ? '' : ' The same command goes on from there.'
  process.stderr.write(`Stopped after ${progress.done} of ${end - first} maps.${again}\n`)
  process.exitCode = INTERRUPTED
}

if (isMainThread) {
  endWithReader()
  await main().catch(tell)
} else serve()
