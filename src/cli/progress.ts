import { durationInWords, timeLeft } from '../experiments/time-left'

const TERMINAL_EVERY_MS = 200
const LOG_EVERY_MS = 10_000

/** Tells on the standard error how far the work is: one line that changes, or a line now and then. */
export class Progress {
  readonly #total: number
  readonly #before: number
  readonly #began = Date.now()
  #done: number
  #told = this.#began

  /** @param before how many of the `total` maps were there when the work began */
  constructor(total: number, before: number) {
    this.#total = total
    this.#before = before
    this.#done = before
  }

  get done(): number {
    return this.#done
  }

  /** One more map is done. */
  add(): void {
    this.#done++
    const now = Date.now()
    const every = process.stderr.isTTY ? TERMINAL_EVERY_MS : LOG_EVERY_MS
    if (now - this.#told < every && this.#done < this.#total) return
    this.#told = now
    const left = timeLeft(this.#done, this.#total, now - this.#began, this.#before)
    const words =
      left === null || this.#done === this.#total ? '' : `, ${durationInWords(left)} left`
    const line = `${this.#count()}${words}`
    process.stderr.write(process.stderr.isTTY ? `\r\x1b[K${line}` : `${line}\n`)
  }

  /** Ends the line that changes. */
  end(): void {
    if (process.stderr.isTTY && this.#told > this.#began) process.stderr.write('\n')
  }

  #count(): string {
    const percent = Math.floor((100 * this.#done) / this.#total)
    return `${this.#done.toLocaleString('en')} of ${this.#total.toLocaleString('en')} maps, ${percent} %`
  }
}
