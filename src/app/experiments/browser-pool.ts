import type { ExperimentSettings } from '../../experiments/settings'
import { askedWorker } from '../planning/asked-worker'
import { type PoolEvents, type PoolWorker, WorkerPool } from './worker-pool'

/** A pool of workers, one for each core. */
export const browserPool = (settings: ExperimentSettings, events: PoolEvents): WorkerPool =>
  new WorkerPool(settings, runWorker, Math.max(1, navigator.hardwareConcurrency || 1), events)

const runWorker = (): PoolWorker =>
  askedWorker(new Worker(new URL('./run-worker.ts', import.meta.url), { type: 'module' }))
