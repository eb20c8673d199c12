import type { ExperimentSettings } from '../../experiments/settings'
import { Crew, type CrewEvents, type Hand } from './crew'

/** A crew of workers, one for each core. */
export const browserCrew = (settings: ExperimentSettings, events: CrewEvents): Crew =>
  new Crew(settings, runWorker, Math.max(1, navigator.hardwareConcurrency || 1), events)

function runWorker(): Hand {
  const worker = new Worker(new URL('./run-worker.ts', import.meta.url), { type: 'module' })
  const hand: Hand = {
    onmessage: null,
    onerror: null,
    postMessage: (order) => worker.postMessage(order),
    terminate: () => worker.terminate(),
  }
  worker.onmessage = (event) => hand.onmessage?.(event)
  worker.onerror = (event) => hand.onerror?.(event)
  return hand
}
