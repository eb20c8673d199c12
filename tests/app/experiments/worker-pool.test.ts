import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { presets } from '../../../src/app/experiments/presets'
import type { Order, Report } from '../../../src/app/experiments/protocol'
import { WorkerPool } from '../../../src/app/experiments/worker-pool'
import type { Row } from '../../../src/experiments/row'
import { runMap } from '../../../src/experiments/run-map'
import { countWork, type ExperimentSettings } from '../../../src/experiments/settings'
import { timeless } from '../../experiments/settings'
import { FakeWorker } from '../fake-worker'

const settings: ExperimentSettings = {
  ...presets[0].settings,
  sizes: [[8, 8]],
  leastDistance: 3,
  mapsPerCombination: 3,
  planners: [
    { planner: 'decomposition', params: {} },
    { planner: 'probabilistic-roadmap', params: { samples: [5, 10] } },
  ],
}
const MAPS = countWork(settings).maps

/** A worker that answers when it is told to. */
class SlowWorker extends FakeWorker<Order, Report> {
  /** Answers the oldest order; whether there was one. */
  work(report: (order: Order) => Report | null = answer): boolean {
    const order = this.questions.shift()
    if (!order || this.isTerminated) return false
    const made = report(order)
    if (made) this.say(made)
    return true
  }
}

let known: ExperimentSettings | null = null

function answer(order: Order): Report | null {
  if (order.kind === 'settings') {
    known = order.settings
    return null
  }
  if (!known) throw new Error('no settings')
  const { range } = order
  const rows: Row[][] = []
  for (let map = range.first; map < range.end; map++) rows.push(runMap(known, map))
  return { kind: 'done', range, rows, milliseconds: 1 }
}

function poolOf(size: number, asked = settings) {
  const workers: SlowWorker[] = []
  const told: (number | string)[] = []
  const pool = new WorkerPool(
    asked,
    () => {
      const worker = new SlowWorker()
      workers.push(worker)
      return worker
    },
    size,
    {
      progressed: (maps) => told.push(maps),
      finished: () => told.push('finished'),
      failed: (message) => told.push(message),
    },
  )
  return { pool, workers, told }
}

const expected = timeless(Array.from({ length: MAPS }, (_, map) => runMap(settings, map)).flat())

describe('a pool of workers', () => {
  it('makes the rows that one alone makes, in the same order, whoever is done first', () => {
    const schedule = fc.tuple(fc.integer({ min: 1, max: 9 }), fc.infiniteStream(fc.nat()))
    fc.assert(
      fc.property(schedule, ([size, choices]) => {
        const { pool, workers, told } = poolOf(size)
        for (const choice of choices) {
          if (told.includes('finished')) break
          workers[choice % workers.length].work()
        }
        expect(timeless(pool.rows)).toEqual(expected)
        expect(told.at(-2)).toBe(MAPS)
        expect(workers.every(({ isTerminated }) => isTerminated)).toBe(true)
      }),
      { numRuns: 30 },
    )
  })

  it('has, when it is stopped, the first maps without a gap, whole ones only', () => {
    const { pool, workers, told } = poolOf(4)
    const [late, , , never] = workers
    for (let i = 0; i < 50; i++) for (const worker of workers.slice(1, 3)) worker.work()
    expect(pool.rows).toEqual([])
    while (late.work());
    pool.stop()
    // The fourth worker was given map 3 first, and nothing from there on counts.
    expect(never.questions).toContainEqual({ kind: 'maps', range: { first: 3, end: 4 } })
    expect(timeless(pool.rows)).toEqual(expected.filter(({ map }) => map < 3))
    expect(told).toEqual([3])
    expect(workers.every(({ isTerminated }) => isTerminated)).toBe(true)
  })

  describe('with thousands of maps', () => {
    const many = { ...settings, mapsPerCombination: 500 }
    const { maps } = countWork(many)

    /** Rows do not matter here. */
    const atOnce = (order: Order): Report | null => {
      if (order.kind === 'settings') return null
      const { range } = order
      const rows = Array.from({ length: range.end - range.first }, () => [])
      return { kind: 'done', range, rows, milliseconds: 1 }
    }

    it('does not let the others run ahead of one that takes long without end', () => {
      const { workers, told } = poolOf(2, many)
      const [late, other] = workers
      let ahead = 0
      const work = (order: Order) => {
        if (order.kind === 'maps') ahead = Math.max(ahead, order.range.end)
        return atOnce(order)
      }
      while (other.work(work));
      expect(ahead).toBe(1000)
      while (late.work(atOnce) || other.work(work));
      expect(told.at(-1)).toBe('finished')
    })

    it('hands out less and less towards the end, so that all workers end together', () => {
      const { workers, told } = poolOf(4, many)
      const counts: number[] = []
      const work = (order: Order) => {
        if (order.kind === 'maps') {
          const { first, end } = order.range
          // Of what is left, no worker gets more than half its share.
          expect(end - first).toBeLessThanOrEqual(Math.ceil((maps - first) / 8))
          counts.push(end - first)
        }
        return atOnce(order)
      }
      while (!told.includes('finished')) for (const worker of workers) worker.work(work)
      expect(Math.max(...counts)).toBe(64)
      expect(counts.at(-1)).toBe(1)
    })
  })

  it('never has more workers than maps, and at least one', () => {
    expect(poolOf(1000).workers).toHaveLength(MAPS)
    expect(poolOf(0).workers).toHaveLength(1)
  })

  it('ends with what is done when a map breaks a worker', () => {
    const { pool, workers, told } = poolOf(2)
    for (const worker of workers) worker.work()
    workers[0].work()
    const before = pool.rows.length
    workers[1].work(() => ({ kind: 'failed', message: 'Map 1: broken' }))
    expect(told.at(-1)).toBe('Map 1: broken')
    expect(pool.rows).toHaveLength(before)
    expect(before).toBeGreaterThan(0)
    expect(workers.every(({ isTerminated }) => isTerminated)).toBe(true)
  })

  it('says so when a worker cannot be started', () => {
    const { workers, told } = poolOf(2)
    let isPrevented = false
    workers[1].onerror?.({ preventDefault: () => (isPrevented = true) })
    expect(told).toEqual(['a worker could not be started'])
    expect(isPrevented).toBe(true)
    expect(workers.every(({ isTerminated }) => isTerminated)).toBe(true)
  })
})
