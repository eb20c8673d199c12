import type { ExperimentSettings } from '../../experiments/settings'
import { askedWorker } from '../asked-worker'
import { Crew, type CrewEvents, type Hand } from './crew'

/** A crew of workers, one for each core. */
export const browserCrew = (settings: ExperimentSettings, events: CrewEvents): Crew =>
  new Crew(settings, runWorker, Math.max(1, navigator.hardwareConcurrency || 1), events)

const runWorker = (): Hand =>
  askedWorker(new Worker(new URL('./run-worker.ts', import.meta.url), { type: 'module' }))
