/** Seeded whole numbers for the tests (xorshift32), apart from the generator that is tested. */
export class Dice {
  private state: number

  constructor(seed: number, index: number) {
    // Neighbouring numbers must not begin alike.
    this.state = Math.imul(index + 1, 0x9e3779b1) ^ Math.imul(seed, 0x5bd1e995) || 1
    for (let i = 0; i < 8; i++) this.next()
  }

  /** A whole number from 0 to `below` - 1. */
  below(below: number): number {
    return Math.floor((this.next() / 2 ** 32) * below)
  }

  /** A whole number from `from` to `to`. */
  between(from: number, to: number): number {
    return from + this.below(to - from + 1)
  }

  /** True once in `n` times. */
  onceIn(n: number): boolean {
    return this.below(n) === 0
  }

  pick<T>(items: readonly T[]): T {
    return items[this.below(items.length)]
  }

  private next(): number {
    let s = this.state
    s ^= s << 13
    s ^= s >>> 17
    s ^= s << 5
    this.state = s
    return s >>> 0
  }
}
