import { askedWorker } from './asked-worker'
import type { PlanningWorker } from './solver'

/** A new worker that plans. */
export const planningWorker = (): PlanningWorker =>
  askedWorker(new Worker(new URL('./plan-worker.ts', import.meta.url), { type: 'module' }))
