import * as v from 'valibot'
import { InputError } from '../errors'
import { describe } from '../excerpt'

/** A whole number, which JSON does not tell from others. */
export const whole = v.pipe(v.number(), v.integer())

/** A list whose items are checked later, once its length is known to be that of a map. */
export const list = v.custom<readonly unknown[]>(Array.isArray)

/**
 * The value if it has the shape.
 * @param words what each key must be, by its path ("size.x") or by its first key
 * @throws InputError that names the first key that is missing or wrong, and what it must be
 */
export function readShape<T>(
  schema: v.GenericSchema<unknown, T>,
  words: Readonly<Record<string, string>>,
  value: unknown,
): T {
  const result = v.safeParse(schema, value, { abortEarly: true })
  if (result.success) return result.output
  const [issue] = result.issues
  const path = v.getDotPath(issue) ?? ''
  const first = issue.path?.[0]
  const at =
    path in words
      ? { name: path, value: issue.input }
      : { name: String(first?.key), value: first?.value }
  if (at.value === undefined) {
    throw new InputError(`"${at.name}" is missing: it must be ${words[at.name]}.`)
  }
  throw new InputError(`"${at.name}" must be ${words[at.name]}, but is ${describe(at.value)}.`)
}
