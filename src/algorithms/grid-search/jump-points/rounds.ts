import type { Direction } from '../../../grid/directions'
import type { Cell } from '../../../grid/grid'

/**
 * Tells when a way on which there is no choice goes round and round: it comes back to the place that
 * is remembered, ever later ones. (R. P. Brent, "An improved Monte Carlo factorization algorithm",
 * 1980.)
 */
export class Rounds {
  #turns = 0
  #remembered = -1

  begin(): void {
    this.#turns = 0
    this.#remembered = -1
  }

  /** Whether it was known that the way goes on from this cell in this direction. */
  isBack(cell: Cell, d: Direction): boolean {
    const place = (cell << 3) | d
    if (place === this.#remembered) return true
    if ((this.#turns & (this.#turns - 1)) === 0) this.#remembered = place
    this.#turns++
    return false
  }
}
