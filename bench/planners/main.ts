import { endWithReader, tell } from '../../src/cli/tell'
import { readCommand, USAGE } from './command'
import { benchGenerated } from './run'
import { benchFiles } from './run-files'

function main(): boolean {
  const command = readCommand(process.argv.slice(2))
  if (command.help) {
    process.stdout.write(USAGE)
    return true
  }
  return command.maps.length + command.scenarios.length > 0
    ? benchFiles(command)
    : benchGenerated(command)
}

endWithReader()
try {
  if (!main()) process.exitCode = 1
} catch (error) {
  tell(error)
}
