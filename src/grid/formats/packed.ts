import { InputError } from '../errors'

/** One bit a cell, eight cells a byte, the first cell in the lowest bit. */
export function packWalls(walls: Uint8Array): Uint8Array {
  const bits = new Uint8Array(Math.ceil(walls.length / 8))
  const whole = walls.length >> 3
  for (let i = 0, at = 0; i < whole; i++, at += 8) {
    bits[i] =
      walls[at] |
      (walls[at + 1] << 1) |
      (walls[at + 2] << 2) |
      (walls[at + 3] << 3) |
      (walls[at + 4] << 4) |
      (walls[at + 5] << 5) |
      (walls[at + 6] << 6) |
      (walls[at + 7] << 7)
  }
  for (let i = 8 * whole; i < walls.length; i++) bits[whole] |= walls[i] << (i & 7)
  return bits
}

/**
 * The walls of `count` cells.
 * @throws InputError if the bits are not those of so many cells.
 */
export function unpackWalls(bits: Uint8Array, count: number): Uint8Array {
  if (bits.length !== Math.ceil(count / 8)) {
    throw new InputError(
      `The packed map has ${bits.length} bytes: too few or too many for ${count} cells.`,
    )
  }
  const walls = new Uint8Array(count)
  const whole = count >> 3
  for (let i = 0, at = 0; i < whole; i++, at += 8) {
    const byte = bits[i]
    walls[at] = byte & 1
    walls[at + 1] = (byte >> 1) & 1
    walls[at + 2] = (byte >> 2) & 1
    walls[at + 3] = (byte >> 3) & 1
    walls[at + 4] = (byte >> 4) & 1
    walls[at + 5] = (byte >> 5) & 1
    walls[at + 6] = (byte >> 6) & 1
    walls[at + 7] = byte >> 7
  }
  for (let i = 8 * whole; i < count; i++) walls[i] = (bits[whole] >> (i & 7)) & 1
  return walls
}
