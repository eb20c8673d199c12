/** What the user or the caller gave cannot be used. The message says what is wrong and where. */
export class InputError extends Error {
  override readonly name = 'InputError'
}

/** The message of whatever was thrown. */
export const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error)
