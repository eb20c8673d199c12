import { InputError } from '../grid/errors'

/** Bad input and missing files are told in a sentence; anything else is a bug, told in full. */
export function tell(error: unknown): void {
  const isPlain = error instanceof InputError || (error instanceof Error && 'syscall' in error)
  const text = isPlain ? error.message : error instanceof Error ? error.stack : String(error)
  process.stderr.write(`${text}\n`)
  process.exitCode = 1
}

/** A reader that has seen enough, such as `head`, ends the program; so does a disk that is full. */
export function endWithReader(): void {
  process.stdout.on('error', (error) => {
    if ('code' in error && error.code === 'EPIPE') process.exit(0)
    tell(error)
    process.exit()
  })
}
