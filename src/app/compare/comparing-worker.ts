import { askedWorker } from '../planning/asked-worker'
import type { CompareWorker } from './comparer'

/** A new worker that compares. */
export const comparingWorker = (): CompareWorker =>
  askedWorker(new Worker(new URL('./compare-worker.ts', import.meta.url), { type: 'module' }))
