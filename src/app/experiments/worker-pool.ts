import { InOrder } from '../../experiments/in-order'
import type { Row } from '../../experiments/row'
import { countWork, type ExperimentSettings } from '../../experiments/settings'
import type { MapRange } from '../../experiments/shards'
import { type AskedWorker, dismiss, listen } from '../planning/asked-worker'
import type { Order, Report } from './protocol'

export type PoolWorker = AskedWorker<Order, Report>

export interface PoolEvents {
  /** More maps are done: so many from the first on, without a gap. */
  progressed(maps: number): void
  /** All maps are done. */
  finished(): void
  /** A worker broke; what was done until then is there. */
  failed(message: string): void
}

/** How long a worker should be busy with a range: long enough to be worth a message. */
const RANGE_MS = 150
const MOST_MAPS = 64

/** How far the others may go on while one map takes long. */
const MOST_AHEAD = 1000

/** Workers that run the maps of one experiment. */
export class WorkerPool {
  readonly #settings: ExperimentSettings
  readonly #total: number
  readonly #events: PoolEvents
  readonly #rows: Row[] = []
  readonly #order: InOrder<readonly Row[]>
  readonly #idle = new Set<PoolWorker>()
  #workers: PoolWorker[]
  #next = 0
  /** How long how many maps took so far. */
  #pace = { maps: 0, milliseconds: 0 }

  /** @param size how many workers; no more are made than there are maps */
  constructor(
    settings: ExperimentSettings,
    makeWorker: () => PoolWorker,
    size: number,
    events: PoolEvents,
  ) {
    this.#settings = settings
    this.#total = countWork(settings).maps
    this.#events = events
    this.#order = new InOrder(0, (rows) => {
      for (const row of rows) this.#rows.push(row)
    })
    const count = Math.max(1, Math.min(size, this.#total))
    this.#workers = Array.from({ length: count }, makeWorker)
    for (const worker of this.#workers) this.#start(worker)
  }

  /** The rows of all maps that are done, from the first on without a gap. */
  get rows(): readonly Row[] {
    return this.#rows
  }

  /** Ends the work. The rows stay. */
  stop(): void {
    for (const worker of this.#workers) dismiss(worker)
    this.#workers = []
  }

  #start(worker: PoolWorker): void {
    listen(
      worker,
      (report) => this.#hear(worker, report),
      (why) => this.#fail(why || 'a worker could not be started'),
    )
    worker.postMessage({ kind: 'settings', settings: this.#settings })
    this.#ask(worker)
  }

  #hear(worker: PoolWorker, report: Report): void {
    if (report.kind === 'failed') this.#fail(report.message)
    else this.#take(worker, report)
  }

  #take(worker: PoolWorker, report: Extract<Report, { kind: 'done' }>): void {
    const { range, rows, milliseconds } = report
    this.#pace = {
      maps: this.#pace.maps + rows.length,
      milliseconds: this.#pace.milliseconds + milliseconds,
    }
    const before = this.#order.next
    rows.forEach((own, i) => {
      this.#order.add(range.first + i, own)
    })
    if (this.#order.next > before) this.#events.progressed(this.#order.next)
    if (this.#order.next === this.#total) {
      this.stop()
      this.#events.finished()
      return
    }
    const waiting = [...this.#idle, worker]
    this.#idle.clear()
    for (const one of waiting) this.#ask(one)
  }

  #ask(worker: PoolWorker): void {
    const range = this.#nextRange()
    if (range) worker.postMessage({ kind: 'maps', range })
    else this.#idle.add(worker)
  }

  #nextRange(): MapRange | null {
    const first = this.#next
    const left = Math.min(this.#total, this.#order.next + MOST_AHEAD) - first
    if (left <= 0) return null
    const { maps, milliseconds } = this.#pace
    const worth = maps === 0 ? 1 : Math.floor((RANGE_MS * maps) / Math.max(milliseconds, 1))
    // Towards the end ranges get shorter, so that all workers end at about the same time.
    const fair = Math.ceil((this.#total - first) / (2 * this.#workers.length))
    this.#next = first + Math.max(1, Math.min(worth, fair, left, MOST_MAPS))
    return { first, end: this.#next }
  }

  #fail(message: string): void {
    this.stop()
    this.#events.failed(message)
  }
}
