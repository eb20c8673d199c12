/**
 * Puts what is finished in any order back into the order of its numbers, so that an experiment that
 * is broken off has its first maps without a gap.
 */
export class InOrder<Item> {
  readonly #waiting = new Map<number, Item>()
  readonly #hand: (item: Item) => void
  #next: number

  /** @param hand is called with one item after the other, beginning with number `first` */
  constructor(first: number, hand: (item: Item) => void) {
    this.#next = first
    this.#hand = hand
  }

  /** The number of the item that is to be handed on next. */
  get next(): number {
    return this.#next
  }

  add(number: number, item: Item): void {
    this.#waiting.set(number, item)
    for (;;) {
      const next = this.#waiting.get(this.#next)
      if (next === undefined) return
      this.#waiting.delete(this.#next)
      this.#hand(next)
      this.#next++
    }
  }
}
