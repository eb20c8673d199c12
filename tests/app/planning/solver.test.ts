import { beforeEach, describe, expect, it } from 'vitest'
import { PATIENCE_MS, Solver } from '../../../src/app/planning/solver'
import type { WorkerAnswer, WorkerQuestion } from '../../../src/app/planning/worker-protocol'
import { timelineOf } from '../../../src/app/playback/timeline'
import { FakeWorker } from '../fake-worker'
import { planned, setupFrom } from '../setups'

class PlanningWorker extends FakeWorker<WorkerQuestion, WorkerAnswer> {
  /** Answers the latest question. */
  finish(): void {
    const { id } = this.questions[this.questions.length - 1]
    const { outcome, tape, last, checkpoints, milliseconds } = planned(base)
    const timeline = timelineOf(tape)
    const data = tape.release()
    this.say({
      kind: 'planned',
      id,
      outcome,
      tape: data,
      last,
      checkpoints,
      timeline,
      milliseconds,
    })
  }
}

const base = setupFrom('S.\n.G')
const request = (seed: number) => ({ setup: { ...base, seed }, instant: true })

let workers: PlanningWorker[]
let now: number
let log: string[]
let solver: Solver

/** The worker in use, and the seeds that it was asked about. */
const worker = () => workers[workers.length - 1]
const asked = (of = worker()) => of.questions.map((question) => question.seed)

beforeEach(() => {
  workers = []
  now = 1000
  log = []
  const makeWorker = () => {
    const made = new PlanningWorker()
    workers.push(made)
    return made
  }
  solver = new Solver(makeWorker, () => now, {
    started: () => log.push('started'),
    progressed: (done) => log.push(`progress ${done}`),
    arrived: ({ setup, instant }) => log.push(`arrived ${setup.seed} ${instant}`),
    failed: ({ setup }, message) => log.push(`failed ${setup.seed} ${message}`),
  })
})

describe('the solver', () => {
  it('has a worker ready before it is asked, and keeps it', () => {
    expect(workers.length).toBe(1)
    for (const seed of [1, 2, 3]) {
      solver.ask(request(seed))
      worker().finish()
    }
    expect(workers.length).toBe(1)
    expect(asked()).toEqual([1, 2, 3])
    expect(log.filter((line) => line.startsWith('arrived'))).toEqual([
      'arrived 1 true',
      'arrived 2 true',
      'arrived 3 true',
    ])
  })

  it('lets only the latest request wait, and hands over the one that was overtaken', () => {
    for (const seed of [1, 2, 3, 4]) solver.ask(request(seed))
    expect(asked()).toEqual([1])
    worker().finish()
    expect(asked()).toEqual([1, 4])
    worker().finish()
    expect(log).toEqual(['started', 'started', 'arrived 1 true', 'arrived 4 true'])
  })

  it('gives up a long run when a newer request comes', () => {
    solver.ask(request(1))
    now += PATIENCE_MS + 1
    solver.ask(request(2))
    expect(workers[0].isTerminated).toBe(true)
    expect(asked()).toEqual([2])
    workers[0].finish()
    expect(log).toEqual(['started', 'started'])
  })

  it('gives up a run that becomes long while a newer request waits', () => {
    solver.ask(request(1))
    now += PATIENCE_MS - 1
    solver.ask(request(2))
    solver.tick()
    expect(workers.length).toBe(1)
    now += 2
    solver.tick()
    expect(workers[0].isTerminated).toBe(true)
    expect(asked()).toEqual([2])
  })

  const edits = (milliseconds: number) => {
    for (let i = 0; i < milliseconds; i += 10) {
      now += 10
      solver.ask(request(1))
    }
  }

  it('gives up later and later while an edit goes on, and soon again when it has ended', () => {
    edits(100 + 200 + 400 + 40)
    expect(workers.length).toBe(4)
    edits(740)
    expect(workers.length).toBe(4)
    solver.editEnded()
    expect(workers.length).toBe(5)
    expect(asked()).toEqual([1])
  })

  it('gives up soon again when an edit was taken back', () => {
    edits(100 + 200 + 400 + 40)
    expect(workers.length).toBe(4)
    solver.ask({ ...request(2), instant: false })
    now += PATIENCE_MS + 1
    solver.tick()
    expect(workers.length).toBe(5)
    expect(asked()).toEqual([2])
  })

  it('never gives up a long run that nobody overtakes', () => {
    solver.ask(request(1))
    now += 60_000
    solver.tick()
    expect(workers.length).toBe(1)
    expect(solver.elapsed).toBe(60_000)
    worker().finish()
    expect(solver.elapsed).toBe(0)
  })

  it('cancels what runs and what waits, and is ready again', () => {
    solver.ask(request(1))
    solver.ask(request(2))
    solver.cancel()
    expect(workers[0].isTerminated).toBe(true)
    workers[0].finish()
    expect(log).toEqual(['started'])
    solver.ask(request(3))
    worker().finish()
    expect(log.at(-1)).toBe('arrived 3 true')
  })

  it('drops an answer to a question that is not the present one', () => {
    solver.ask(request(1))
    worker().say({ kind: 'refused', id: 99, message: 'old' })
    expect(log).toEqual(['started'])
  })

  it('tells progress, but not that of a run that was overtaken', () => {
    solver.ask(request(1))
    worker().say({ kind: 'progress', id: 1, done: 0.5 })
    solver.ask(request(2))
    worker().say({ kind: 'progress', id: 1, done: 0.6 })
    expect(log).toEqual(['started', 'progress 0.5'])
  })

  it('tells what was refused, and goes on with what waits', () => {
    solver.ask(request(1))
    solver.ask(request(2))
    worker().say({ kind: 'refused', id: 1, message: 'The start is an obstacle.' })
    expect(log).toEqual(['started', 'started', 'failed 1 The start is an obstacle.'])
  })

  it('survives a worker that breaks, without making new ones for ever', () => {
    solver.ask(request(1))
    worker().onerror?.({ message: 'out of memory' })
    expect(log).toEqual(['started', 'failed 1 out of memory'])
    expect(workers.length).toBe(1)
    solver.ask(request(2))
    expect(workers.length).toBe(2)
    worker().finish()
    expect(log.at(-1)).toBe('arrived 2 true')
  })
})
