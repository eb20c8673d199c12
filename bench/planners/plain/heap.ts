/** A binary heap of numbers by their keys, the least first. */
export class Heap {
  readonly #items: number[] = []
  readonly #keys: number[] = []

  push(item: number, key: number): void {
    const items = this.#items
    const keys = this.#keys
    let place = items.length
    while (place > 0) {
      const above = (place - 1) >> 1
      if (keys[above] <= key) break
      items[place] = items[above]
      keys[place] = keys[above]
      place = above
    }
    items[place] = item
    keys[place] = key
  }

  /** Takes the item with the least key out; undefined if there is none. */
  pop(): number | undefined {
    const items = this.#items
    const keys = this.#keys
    const least = items[0]
    const item = items.pop()
    const key = keys.pop()
    if (item === undefined || key === undefined || items.length === 0) return least
    let place = 0
    for (;;) {
      let below = 2 * place + 1
      if (below >= items.length) break
      if (below + 1 < items.length && keys[below + 1] < keys[below]) below++
      if (keys[below] >= key) break
      items[place] = items[below]
      keys[place] = keys[below]
      place = below
    }
    items[place] = item
    keys[place] = key
    return least
  }
}
