import { InputError } from '../errors'
import { excerpt } from '../excerpt'

/** No map nests deeper, and a parser handed a million brackets runs out of memory. */
const MAX_DEPTH = 100

/**
 * The value of a JSON text. Its syntax is checked here first, because engines name the place of an
 * error each in their own way or not at all.
 * @throws InputError with the line and the column of what is not JSON.
 */
export function parseJson(text: string): unknown {
  const fault = firstFault(text)
  if (fault === null) return JSON.parse(text)
  const before = text.slice(0, fault.at)
  const line = before.split('\n').length
  const column = fault.at - before.lastIndexOf('\n')
  const found = fault.at < text.length ? `found ${excerpt(text.slice(fault.at), 12)}` : 'it ends'
  throw new InputError(
    `The file is broken in line ${line}, column ${column}: expected ${fault.expected}, but ${found}.`,
  )
}

// What may come next; the words are those of the message.
const VALUE = 'a value'
const VALUE_OR_END = 'a value or "]"'
const KEY = 'a key in double quotes'
const KEY_OR_END = 'a key in double quotes or "}"'
const COLON = '":"'
const COMMA_IN_LIST = '"," or "]"'
const COMMA_IN_OBJECT = '"," or "}"'
const END = 'nothing more'

/** The first place where the text is not JSON, and what could have stood there; `null` if none. */
function firstFault(text: string): { readonly expected: string; readonly at: number } | null {
  /** The brackets that are open, the innermost last. */
  const open: ('[' | '{')[] = []
  const afterValue = () =>
    open.length === 0 ? END : open[open.length - 1] === '[' ? COMMA_IN_LIST : COMMA_IN_OBJECT
  let expected: string = VALUE
  for (
    let at = skipSpace(text, 0);
    at < text.length || expected !== END;
    at = skipSpace(text, at)
  ) {
    const sign = text[at]
    const value = expected === VALUE || expected === VALUE_OR_END
    const key = expected === KEY || expected === KEY_OR_END
    if (value && (sign === '[' || sign === '{')) {
      if (open.push(sign) > MAX_DEPTH) return { expected: `at most ${MAX_DEPTH} levels`, at }
      expected = sign === '[' ? VALUE_OR_END : KEY_OR_END
      at++
    } else if (
      (sign === ']' && (expected === VALUE_OR_END || expected === COMMA_IN_LIST)) ||
      (sign === '}' && (expected === KEY_OR_END || expected === COMMA_IN_OBJECT))
    ) {
      open.pop()
      expected = afterValue()
      at++
    } else if (sign === ',' && (expected === COMMA_IN_LIST || expected === COMMA_IN_OBJECT)) {
      expected = expected === COMMA_IN_LIST ? VALUE : KEY
      at++
    } else if (sign === ':' && expected === COLON) {
      expected = VALUE
      at++
    } else if (sign === '"' && (value || key)) {
      at = endOfString(text, at)
      if (text[at] !== '"') return { expected: 'the rest of a text in double quotes', at }
      expected = key ? COLON : afterValue()
      at++
    } else {
      const end = value ? endOfWord(text, at) : at
      if (end === at) return { expected, at }
      expected = afterValue()
      at = end
    }
  }
  return null
}

function skipSpace(text: string, from: number): number {
  for (let at = from; ; at++) {
    const code = text.charCodeAt(at)
    const space = code === 0x20 || code === 0x0a || code === 0x0d || code === 0x09
    if (!space) return at
  }
}

const [QUOTE, BACKSLASH, SPACE] = Array.from('"\\ ', (sign) => sign.charCodeAt(0))
const ESCAPE = /\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})/y

/** The place of the closing quote, or of what must not stand in a string. */
function endOfString(text: string, from: number): number {
  for (let at = from + 1; ; at++) {
    // By their codes: a text may be a row of a large map. There is none after the end.
    const code = text.charCodeAt(at)
    if (!(code >= SPACE) || code === QUOTE) return at
    if (code !== BACKSLASH) continue
    ESCAPE.lastIndex = at
    if (!ESCAPE.test(text)) return at
    at = ESCAPE.lastIndex - 1
  }
}

// The numbers of digits are bounded because an expression may run out of stack on a million.
const WORD = /true|false|null|-?(?:0|[1-9]\d{0,99})(?:\.\d{1,99})?(?:[eE][+-]?\d{1,9})?/y

/** The place after the number, `true`, `false` or `null` that begins at `from`; `from` if none does. */
function endOfWord(text: string, from: number): number {
  const next = text[from + 1]
  // Most numbers of a map are one digit.
  if ((next === ',' || next === ']') && text[from] >= '0' && text[from] <= '9') return from + 1
  WORD.lastIndex = from
  return WORD.test(text) ? WORD.lastIndex : from
}
