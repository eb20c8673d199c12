import { messageOf } from '../../grid/errors'
import type { OpenedMap } from '../../grid/formats/opened-map'
import { MISSING_PART } from '../fetched-part'
import { type AskedWorker, dismiss, listen, send } from '../planning/asked-worker'

/** What a worker says that was asked for a map. */
export type MapAnswer =
  | ({ readonly kind: 'made' } & OpenedMap)
  | { readonly kind: 'refused'; readonly message: string }

/** A worker that makes one map. */
export type MapWorker<Question> = AskedWorker<Question, MapAnswer>

/**
 * Asks a worker for a map, and ends it when the map is there or not wanted any more.
 * @throws what the signal was aborted with, or an Error that says why there is no map
 */
export function askForMap<Question>(
  worker: MapWorker<Question>,
  question: Question,
  signal: AbortSignal,
): Promise<OpenedMap> {
  return new Promise<OpenedMap>((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason))
    listen(
      worker,
      (answer) => (answer.kind === 'made' ? resolve(answer) : reject(new Error(answer.message))),
      (why) => reject(new Error(why || MISSING_PART)),
    )
    worker.postMessage(question)
  }).finally(() => dismiss(worker))
}

/** From within a worker: answers what it is asked with a map, or with the reason why there is none. */
export function answerWithMap<Question>(
  make: (question: Question) => OpenedMap | Promise<OpenedMap>,
): void {
  self.onmessage = async ({ data }: MessageEvent<Question>) => {
    try {
      const { problem, notes } = await make(data)
      send<MapAnswer>({ kind: 'made', problem, notes }, [problem.grid.walls.buffer])
    } catch (error) {
      send<MapAnswer>({ kind: 'refused', message: messageOf(error) })
    }
  }
}
