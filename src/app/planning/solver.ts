import type { Setup } from '../state/setup'
import { type AskedWorker, dismiss, listen } from './asked-worker'
import type { WorkerAnswer, WorkerQuestion } from './worker-protocol'
import { questionOf } from './worker-protocol'

export type PlanningWorker = AskedWorker<WorkerQuestion, WorkerAnswer>

export interface PlanRequest {
  readonly setup: Setup
  /** Whether it comes from an edit that is still going on. */
  readonly instant: boolean
}

export interface SolverEvents {
  started(): void
  progressed(done: number): void
  arrived(request: PlanRequest, answer: Extract<WorkerAnswer, { kind: 'planned' }>): void
  failed(request: PlanRequest, message: string): void
}

/** How long a plan that nobody wants any more may go on before its worker is given up. */
export const PATIENCE_MS = 100
/** Patience grows with each run that is given up in a stroke: to begin anew takes time as well. */
const MOST_PATIENCE_MS = 16 * PATIENCE_MS

/**
 * Keeps one worker and asks it one thing at a time. While it works, only the latest request waits.
 * A plan that has been overtaken is still handed over if it comes soon: it is newer than what is on
 * screen, and so the path follows the pointer; when patience is at an end its worker is replaced.
 */
export class Solver {
  readonly #makeWorker: () => PlanningWorker
  readonly #now: () => number
  readonly #events: SolverEvents
  #worker: PlanningWorker | null
  #running: { readonly id: number; readonly request: PlanRequest; readonly since: number } | null =
    null
  #waiting: PlanRequest | null = null
  #questions = 0
  #patience = PATIENCE_MS

  constructor(makeWorker: () => PlanningWorker, now: () => number, events: SolverEvents) {
    this.#makeWorker = makeWorker
    this.#now = now
    this.#events = events
    this.#worker = this.#newWorker()
  }

  /** How long the present plan has been worked on; 0 if there is none. */
  get elapsed(): number {
    return this.#running ? this.#now() - this.#running.since : 0
  }

  ask(request: PlanRequest): void {
    this.#waiting = request
    if (!request.instant) this.#patience = PATIENCE_MS
    if (this.#running) this.tick()
    else this.#startWaiting()
  }

  /** To be called in every frame while a plan is worked on. */
  tick(): void {
    if (!this.#running || !this.#waiting || this.elapsed <= this.#patience) return
    this.#patience = Math.min(2 * this.#patience, MOST_PATIENCE_MS)
    this.#replaceWorker()
    this.#startWaiting()
  }

  /** The edit is over: what waits is what counts. */
  editEnded(): void {
    this.#patience = PATIENCE_MS
    this.tick()
  }

  /** Gives up all that is worked on or waits; nothing of it arrives. */
  cancel(): void {
    this.#waiting = null
    if (this.#running) this.#replaceWorker()
  }

  #newWorker(): PlanningWorker {
    const worker = this.#makeWorker()
    listen(
      worker,
      (answer) => this.#answered(answer),
      (why) => this.#broke(why || 'the planning worker could not be started'),
    )
    return worker
  }

  #dropWorker(): void {
    if (this.#worker) dismiss(this.#worker)
    this.#worker = null
    this.#running = null
  }

  /** The new one is made at once, so that it has started by the time it is asked. */
  #replaceWorker(): void {
    this.#dropWorker()
    this.#worker = this.#newWorker()
  }

  #startWaiting(): void {
    const request = this.#waiting
    if (!request) return
    this.#waiting = null
    this.#questions++
    this.#running = { id: this.#questions, request, since: this.#now() }
    this.#events.started()
    this.#worker ??= this.#newWorker()
    this.#worker.postMessage(questionOf(this.#questions, request.setup))
  }

  #answered(answer: WorkerAnswer): void {
    const running = this.#running
    if (!running || answer.id !== running.id) return
    if (answer.kind === 'progress') {
      if (!this.#waiting) this.#events.progressed(answer.done)
      return
    }
    this.#running = null
    this.#patience = PATIENCE_MS
    // The worker goes on before the page takes its time to show the answer.
    this.#startWaiting()
    if (answer.kind === 'planned') this.#events.arrived(running.request, answer)
    else this.#events.failed(running.request, answer.message)
  }

  #broke(message: string): void {
    const running = this.#running
    // No new one is made before it is needed: what broke this one might break each of them.
    this.#dropWorker()
    if (running) this.#events.failed(running.request, message)
    this.#startWaiting()
  }
}
