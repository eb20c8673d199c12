import { availableParallelism } from 'node:os'
import { readShard, type Shard, WHOLE } from '../experiments/shards'
import { InputError } from '../grid/errors'
import { parseArguments } from './arguments'

export const USAGE = `Runs an experiment: the planners and maps that a settings file names.

  npm run experiment -- settings.json [--out rows.jsonl] [--shard i/n] [--workers k]
  npm run experiment -- --merge [--out rows.jsonl] shard1.jsonl shard2.jsonl …

  --out      where the rows go, as JSON lines; without it they are printed
             (with "npm run -s", or npm prints lines of its own above them).
             A run that was broken off goes on where its file ends. While one
             writes to it, a file whose name ends in ".lock" keeps others out.
  --shard    only the i-th of n parts of the maps
  --workers  how many threads work (as many as there are cores, if nothing else is said)
  --merge    joins the files of all shards into the one that a single run would have made
`

const OPTIONS = {
  out: { type: 'string' },
  shard: { type: 'string' },
  workers: { type: 'string' },
  merge: { type: 'boolean' },
} as const

export type Command =
  | { readonly kind: 'help' }
  | {
      readonly kind: 'run'
      readonly settings: string
      readonly out: string | null
      readonly shard: Shard
      readonly workers: number
    }
  | { readonly kind: 'merge'; readonly files: readonly string[]; readonly out: string | null }

/**
 * What the arguments of the command line ask for.
 * @throws InputError that says which argument is wrong
 */
export function readCommand(args: readonly string[]): Command {
  const { values, positionals } = parseArguments(args, OPTIONS, USAGE)
  if (values.help) return { kind: 'help' }
  const out = values.out ?? null
  if (out !== null && /(^|[/\\])$/.test(out)) {
    throw new InputError(`--out must name a file, but is "${out}".`)
  }
  if (values.merge) {
    if (positionals.length === 0) throw new InputError('--merge needs the files of the shards.')
    for (const name of ['shard', 'workers'] as const) {
      if (values[name] !== undefined) throw new InputError(`--merge runs nothing: no --${name}.`)
    }
    return { kind: 'merge', files: positionals, out }
  }
  const [settings, ...others] = positionals
  if (settings === undefined) throw new InputError(`The settings file is missing.\n\n${USAGE}`)
  if (others.length > 0) throw new InputError(`One settings file at a time: what is ${others[0]}?`)
  const shard = values.shard === undefined ? WHOLE : readShard(values.shard)
  return { kind: 'run', settings, out, shard, workers: readWorkers(values.workers) }
}

function readWorkers(text: string | undefined): number {
  if (text === undefined) return availableParallelism()
  const workers = Number(text)
  if (Number.isInteger(workers) && workers >= 1 && workers <= 1024) return workers
  throw new InputError(`--workers must be a whole number from 1 to 1024, but is "${text}".`)
}
