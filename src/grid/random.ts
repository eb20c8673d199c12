/** The greatest seed that forms and settings files take; the least is 0. */
export const MAX_SEED = 2 ** 31 - 1

/**
 * Seeded random numbers from 0 up to 1, without it, the same on every machine (splitmix32, after Steele, Lea
 * and Flood, "Fast splittable pseudorandom number generators", 2014).
 */
export function randomNumbers(seed: number): () => number {
  let state = seed | 0
  return () => {
    state = (state + 0x9e3779b9) | 0
    let z = state
    z = Math.imul(z ^ (z >>> 16), 0x21f0aaad)
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97)
    return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32
  }
}

/** A whole number from 0 to `below` - 1. */
export function randomInteger(random: () => number, below: number): number {
  return Math.floor(random() * below)
}
