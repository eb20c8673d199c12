import type { MapWorker } from '../files/map-worker'
import { askedWorker } from '../planning/asked-worker'
import type { WantedMap } from './wanted-map'

/** A new worker that generates one map. */
export const generatingWorker = (): MapWorker<WantedMap> =>
  askedWorker(new Worker(new URL('./generate-worker.ts', import.meta.url), { type: 'module' }))
