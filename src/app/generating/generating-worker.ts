import type { Problem } from '../../grid/problem'
import { type AskedWorker, askedWorker, dismiss, listen } from '../planning/asked-worker'
import type { GeneratingAnswer, WantedMap } from './wanted-map'

export type GeneratingWorker = AskedWorker<WantedMap, GeneratingAnswer>

/** A new worker that generates one map. */
export const generatingWorker = (): GeneratingWorker =>
  askedWorker(new Worker(new URL('./generate-worker.ts', import.meta.url), { type: 'module' }))

/**
 * Asks a worker for a map, and ends it when the map is there or not wanted any more.
 * @throws what the signal was aborted with, or an Error that says why there is no map
 */
export function askForMap(
  worker: GeneratingWorker,
  wanted: WantedMap,
  signal: AbortSignal,
): Promise<Problem> {
  return new Promise<Problem>((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason))
    listen(
      worker,
      (answer) =>
        answer.kind === 'generated' ? resolve(answer.problem) : reject(new Error(answer.message)),
      (why) => reject(new Error(why || 'The generating worker could not be started.')),
    )
    worker.postMessage(wanted)
  }).finally(() => dismiss(worker))
}
