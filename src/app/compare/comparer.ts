import { type AskedWorker, dismiss, listen } from '../planning/asked-worker'
import type { ComparedPlan, Subject } from './compared'
import type { CompareAnswer, CompareQuestion } from './protocol'

export type CompareWorker = AskedWorker<CompareQuestion, CompareAnswer>

export interface ComparerEvents {
  planned(subject: Subject, plan: ComparedPlan): void
  timed(subject: Subject, plannerId: string, milliseconds: number): void
  /** All plans and all times are there. */
  finished(subject: Subject): void
  failed(subject: Subject, message: string): void
}

/** How long plans that nobody wants any more may go on before their worker is given up. */
export const PATIENCE_MS = 400

/**
 * Keeps one worker while planners are compared. While it plans, only the latest subject waits, and
 * what has been overtaken is still handed over, so that the paths follow the pointer; while it takes
 * times, the next subject is asked about at once.
 */
export class Comparer {
  readonly #makeWorker: () => CompareWorker
  readonly #events: ComparerEvents
  #worker: CompareWorker | null = null
  #running: { readonly id: number; readonly subject: Subject; readonly since: number } | null = null
  #isPlanning = false
  #waiting: Subject | null = null
  #timer: ReturnType<typeof setTimeout> | undefined
  #questions = 0

  constructor(makeWorker: () => CompareWorker, events: ComparerEvents) {
    this.#makeWorker = makeWorker
    this.#events = events
  }

  ask(subject: Subject): void {
    this.#waiting = subject
    if (!this.#running || !this.#isPlanning) {
      this.#startWaiting()
      return
    }
    clearTimeout(this.#timer)
    const left = this.#running.since + PATIENCE_MS - Date.now()
    this.#timer = setTimeout(() => this.#giveUp(), Math.max(0, left))
  }

  /** Gives up all that is worked on or waits, and the worker. */
  stop(): void {
    this.#waiting = null
    this.#dropWorker()
  }

  #giveUp(): void {
    this.#dropWorker()
    this.#startWaiting()
  }

  #dropWorker(): void {
    clearTimeout(this.#timer)
    if (this.#worker) dismiss(this.#worker)
    this.#worker = null
    this.#running = null
  }

  #newWorker(): CompareWorker {
    const worker = this.#makeWorker()
    listen(
      worker,
      (answer) => this.#answered(answer),
      (why) => this.#broke(why || 'the comparing worker could not be started'),
    )
    return worker
  }

  #startWaiting(): void {
    const subject = this.#waiting
    if (!subject) return
    clearTimeout(this.#timer)
    this.#waiting = null
    this.#questions++
    this.#running = { id: this.#questions, subject, since: Date.now() }
    this.#isPlanning = true
    this.#worker ??= this.#newWorker()
    const { problem, params, seed } = subject
    this.#worker.postMessage({ id: this.#questions, subject: { problem, params, seed } })
  }

  #answered(answer: CompareAnswer): void {
    const running = this.#running
    if (!running || answer.id !== running.id) return
    const { subject } = running
    switch (answer.kind) {
      case 'planned':
        this.#events.planned(subject, answer.plan)
        break
      case 'compared':
        this.#isPlanning = false
        this.#startWaiting()
        break
      case 'timed':
        this.#events.timed(subject, answer.plannerId, answer.milliseconds)
        break
      case 'finished':
        this.#running = null
        this.#events.finished(subject)
        break
      case 'failed':
        this.#broke(answer.message)
        break
    }
  }

  #broke(message: string): void {
    const subject = this.#running?.subject
    this.#dropWorker()
    if (subject) this.#events.failed(subject, message)
    this.#startWaiting()
  }
}
