/** A rectangle of cells: columns `left` to `right` - 1, rows `top` to `bottom` - 1. */
export interface Box {
  readonly left: number
  readonly top: number
  readonly right: number
  readonly bottom: number
}

/** The smallest box around cells that are added one by one; empty as long as `right` is 0. */
export class GrowingBox implements Box {
  left = Number.POSITIVE_INFINITY
  top = Number.POSITIVE_INFINITY
  right = 0
  bottom = 0

  get isEmpty(): boolean {
    return this.right === 0
  }

  include(x: number, y: number): void {
    if (x < this.left) this.left = x
    if (y < this.top) this.top = y
    if (x >= this.right) this.right = x + 1
    if (y >= this.bottom) this.bottom = y + 1
  }

  includeBox({ left, top, right, bottom }: Box): void {
    this.include(left, top)
    this.include(right - 1, bottom - 1)
  }

  clear(): void {
    this.left = Number.POSITIVE_INFINITY
    this.top = Number.POSITIVE_INFINITY
    this.right = 0
    this.bottom = 0
  }
}
