import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { InputError } from '../grid/errors'

/**
 * Does work that writes to a file, and keeps other runs from writing to it meanwhile. The file beside
 * it that says so names this process: it counts no more when that was killed and left it behind. A
 * folder that is missing is made.
 * @param path of the file; `null` for the standard output, which nobody else writes to
 * @throws InputError if another run writes to the file
 */
export async function whileLocked(path: string | null, work: () => Promise<void>): Promise<void> {
  if (path === null) return work()
  const lock = `${path}.lock`
  if (existsSync(lock)) {
    const owner = Number(readFileSync(lock, 'utf8'))
    if (isRunning(owner)) {
      throw new InputError(
        `Another run, process ${owner}, writes to ${path}. If that is not so, delete ${lock}.`,
      )
    }
    rmSync(lock)
  }
  mkdirSync(dirname(path), { recursive: true })
  writeFileSync(lock, String(process.pid), { flag: 'wx' })
  try {
    await work()
  } finally {
    rmSync(lock)
  }
}

function isRunning(id: number): boolean {
  // After a power cut the lock may be empty; 0 and less stand for groups of processes.
  if (!(id > 0)) return false
  try {
    return process.kill(id, 0)
  } catch (error) {
    // Another user's process may not be signalled.
    return error instanceof Error && 'code' in error && error.code === 'EPERM'
  }
}
