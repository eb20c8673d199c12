/** The first `length` characters of a text, in quotes for a message; what cannot be printed is "·". */
export function excerpt(text: string, length = 30): string {
  const signs = Array.from(text.slice(0, 2 * length + 2))
  const shown = signs
    .slice(0, length)
    .join('')
    .replace(/[^\p{L}\p{M}\p{N}\p{P}\p{S} ]/gu, '·')
  return signs.length > length && length > 1 ? `"${shown}…"` : `"${shown}"`
}

/** Any value of a JSON file in a few words, for a message. */
export function describe(value: unknown): string {
  if (typeof value === 'string') return excerpt(value)
  if (Array.isArray(value)) {
    const flat = value.length <= 3 && value.every((item) => typeof item !== 'object')
    return flat ? `[${value.map(describe).join(', ')}]` : `a list of ${value.length}`
  }
  return typeof value === 'object' && value !== null ? 'an object' : String(value)
}
