import { InputError } from './errors'
import { describe } from './excerpt'

/**
 * The text of a file without the byte order mark that some editors begin it with.
 * @throws InputError if it is no text: the bytes of the file, say
 */
export function fileText(text: string): string {
  if (typeof text === 'string') return text.charCodeAt(0) === 0xfeff ? text.slice(1) : text
  throw new InputError(`A text is needed, but this is ${describe(text)}.`)
}
