import { parseArguments } from '../../src/cli/arguments'
import { InputError } from '../../src/grid/errors'

export const USAGE = `Times our planners and those of other libraries in turn.

  npm run bench                        all cases, and exit code 1 if one is behind its target
  npm run bench -- --only 'a-star'     the cases with this in their names
  npm run bench -- --quick             no maps of a million cells, and no growth
  npm run bench -- --docs              all of it, written down in docs/speed.md
  npm run bench -- a.map a.map.scen    maps and scenarios of the MovingAI benchmarks instead
`

const OPTIONS = {
  only: { type: 'string' },
  quick: { type: 'boolean' },
  docs: { type: 'boolean' },
} as const

export interface Command {
  readonly help: boolean
  readonly quick: boolean
  readonly docs: boolean
  /** Part of the names of the cases to be timed; empty for all. */
  readonly only: string
  readonly maps: readonly string[]
  readonly scenarios: readonly string[]
}

/**
 * What the arguments of the command line ask for.
 * @throws InputError that says which argument is wrong
 */
export function readCommand(args: readonly string[]): Command {
  const { values, positionals } = parseArguments(args, OPTIONS, USAGE)
  const { help = false, quick = false, docs = false, only = '' } = values
  const maps = positionals.filter((file) => file.endsWith('.map'))
  const scenarios = positionals.filter((file) => file.endsWith('.scen'))
  const other = positionals.find((file) => !maps.includes(file) && !scenarios.includes(file))
  if (other !== undefined) {
    throw new InputError(`${other} is neither a .map nor a .scen file.\n\n${USAGE}`)
  }
  if (positionals.length > 0 && (quick || only !== '')) {
    throw new InputError('--quick and --only choose among the generated maps: no files with them.')
  }
  if (docs && (quick || only !== '' || positionals.length > 0)) {
    throw new InputError('--docs writes down the whole bench: it goes with nothing else.')
  }
  return { help, quick, docs, only, maps, scenarios }
}
