/** What the user or the caller gave cannot be used. The message says what is wrong and where. */
export class InputError extends Error {
  override readonly name = 'InputError'
}
