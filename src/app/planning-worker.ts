import type { WorkerLike } from './solver'

/** A new worker that plans. */
export function planningWorker(): WorkerLike {
  const worker = new Worker(new URL('./plan-worker.ts', import.meta.url), { type: 'module' })
  const like: WorkerLike = {
    onmessage: null,
    onerror: null,
    postMessage: (question) => worker.postMessage(question),
    terminate: () => worker.terminate(),
  }
  worker.onmessage = (event) => like.onmessage?.(event)
  worker.onerror = (event) => like.onerror?.(event)
  return like
}
