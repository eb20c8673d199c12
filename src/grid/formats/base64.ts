import { InputError } from '../errors'

const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/'
const CODES = Uint8Array.from(DIGITS, (digit) => digit.charCodeAt(0))
const VALUES = new Int8Array(128).fill(-1)
CODES.forEach((code, value) => {
  VALUES[code] = value
})

const PADDING = '='.charCodeAt(0)

/** Base64 (RFC 4648, section 4) with padding. Written by hand, because browsers and Node offer no common function. */
export function toBase64(bytes: Uint8Array): string {
  const codes = new Uint8Array(Math.ceil(bytes.length / 3) * 4)
  let at = 0
  for (let i = 0; i < bytes.length; i += 3) {
    // Bytes beyond the end count as 0.
    const three = (bytes[i] << 16) | ((bytes[i + 1] ?? 0) << 8) | (bytes[i + 2] ?? 0)
    for (let shift = 18; shift >= 0; shift -= 6) codes[at++] = CODES[(three >> shift) & 63]
  }
  codes.fill(PADDING, codes.length - ((3 - (bytes.length % 3)) % 3))
  return textOf(codes)
}

/** In pieces, because a call takes only so many arguments. Spread syntax would take much longer. */
function textOf(codes: Uint8Array): string {
  const pieces: string[] = []
  for (let i = 0; i < codes.length; i += 4096) {
    pieces.push(Reflect.apply(String.fromCharCode, null, codes.subarray(i, i + 4096)))
  }
  return pieces.join('')
}

/**
 * The bytes of a Base64 text as `toBase64` writes it, and of no other.
 * @throws InputError if the length, a character or the end is not Base64's.
 */
export function fromBase64(text: string): Uint8Array {
  if (text.length % 4 !== 0) {
    throw new InputError(`Base64 comes in groups of 4 characters, but there are ${text.length}.`)
  }
  const padding = text.endsWith('==') ? 2 : text.endsWith('=') ? 1 : 0
  const bytes = new Uint8Array((text.length / 4) * 3 - padding)
  let bits = 0
  let count = 0
  let at = 0
  for (let i = 0; i < text.length - padding; i++) {
    const value = VALUES[text.charCodeAt(i)] ?? -1
    if (value < 0) throw new InputError(`Character ${i + 1} of the packed map is not Base64.`)
    bits = ((bits << 6) | value) & 0xffff
    count += 6
    if (count < 8) continue
    count -= 8
    bytes[at++] = bits >> count
  }
  if (bits & ((1 << count) - 1)) throw new InputError('The packed map is cut off at its end.')
  return bytes
}
