import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { Comparer, PATIENCE_MS } from '../../../src/app/compare/comparer'
import type { CompareAnswer, CompareQuestion } from '../../../src/app/compare/protocol'
import { FakeWorker } from '../fake-worker'
import { entriesOf, walled } from './setups'

class ComparingWorker extends FakeWorker<CompareQuestion, CompareAnswer> {
  /** Of the latest question. */
  get id(): number {
    return this.questions[this.questions.length - 1].id
  }
}

const [{ plan }] = entriesOf()
const subject = (seed: number) => ({ ...walled, seed })
let workers: ComparingWorker[]
let log: string[]
let comparer: Comparer

const worker = () => workers[workers.length - 1]
const asked = (of = worker()) => of.questions.map((question) => question.subject.seed)

beforeEach(() => {
  vi.useFakeTimers()
  workers = []
  log = []
  const makeWorker = () => {
    workers.push(new ComparingWorker())
    return worker()
  }
  comparer = new Comparer(makeWorker, {
    planned: ({ seed }) => log.push(`planned ${seed}`),
    timed: ({ seed }, id) => log.push(`timed ${seed} ${id}`),
    finished: ({ seed }) => log.push(`finished ${seed}`),
    failed: ({ seed }, message) => log.push(`failed ${seed} ${message}`),
  })
})

afterEach(() => {
  vi.useRealTimers()
})

it('has no worker before it is asked', () => {
  expect(workers.length).toBe(0)
})

it('lets only the latest subject wait while it plans, and hands over what was overtaken', () => {
  for (const seed of [1, 2, 3]) comparer.ask(subject(seed))
  expect(asked()).toEqual([1])
  worker().say({ kind: 'planned', id: worker().id, plan })
  worker().say({ kind: 'compared', id: worker().id })
  expect(asked()).toEqual([1, 3])
  expect(log).toEqual(['planned 1'])
})

it('asks at once while times are taken, and drops those that come late', () => {
  comparer.ask(subject(1))
  const { id } = worker()
  worker().say({ kind: 'compared', id })
  worker().say({ kind: 'timed', id, plannerId: 'bug1', milliseconds: 1 })
  comparer.ask(subject(2))
  expect(asked()).toEqual([1, 2])
  worker().say({ kind: 'timed', id, plannerId: 'bug2', milliseconds: 1 })
  worker().say({ kind: 'finished', id })
  expect(log).toEqual(['timed 1 bug1'])
  worker().say({ kind: 'finished', id: worker().id })
  expect(log).toEqual(['timed 1 bug1', 'finished 2'])
  expect(workers.length).toBe(1)
})

it('gives up plans that nobody waits for any more, after some patience', () => {
  comparer.ask(subject(1))
  comparer.ask(subject(2))
  vi.advanceTimersByTime(PATIENCE_MS - 1)
  expect(workers.length).toBe(1)
  vi.advanceTimersByTime(1)
  expect(workers[0].isTerminated).toBe(true)
  expect(asked()).toEqual([2])
  vi.advanceTimersByTime(10 * PATIENCE_MS)
  expect(workers.length).toBe(2)
})

it('stops with its worker', () => {
  comparer.ask(subject(1))
  comparer.ask(subject(2))
  comparer.stop()
  vi.advanceTimersByTime(10 * PATIENCE_MS)
  expect(workers.length).toBe(1)
  expect(workers[0].isTerminated).toBe(true)
  expect(log).toEqual([])
})

it('tells of a worker that broke, and makes another for the next subject', () => {
  comparer.ask(subject(1))
  worker().onerror?.({ message: 'out of memory' })
  expect(log).toEqual(['failed 1 out of memory'])
  comparer.ask(subject(2))
  expect(workers.length).toBe(2)
})
