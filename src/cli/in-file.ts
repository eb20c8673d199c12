import { InputError } from '../grid/errors'

/** What `read` returns. An InputError that it throws gets the path of the file before its message. */
export function inFile<T>(path: string, read: () => T): T {
  try {
    return read()
  } catch (error) {
    throw error instanceof InputError ? new InputError(`${path}: ${error.message}`) : error
  }
}
