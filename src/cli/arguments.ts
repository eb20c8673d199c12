import { type ParseArgsConfig, parseArgs } from 'node:util'
import { InputError, messageOf } from '../grid/errors'

/**
 * The options, and what stands between them, on a command line; `--help` is one everywhere.
 * @throws InputError for options that are none of these, with `usage` below it
 */
export function parseArguments<const Options extends NonNullable<ParseArgsConfig['options']>>(
  args: readonly string[],
  options: Options,
  usage: string,
) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: { ...options, help: { type: 'boolean', short: 'h' } },
    })
  } catch (error) {
    const message = messageOf(error)
    throw new InputError(`${message}\n\n${usage}`)
  }
}
